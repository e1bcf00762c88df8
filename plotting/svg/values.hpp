#pragma once
/// The values of SVG attributes: numbers, lengths, transforms. Private to plotting.
///
/// Every reader throws std::invalid_argument with a phrase if the text is invalid.

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "plotting/page.hpp"

namespace ligne::svg {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Matrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Point2 operator()(Point2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// Applies `other` first, then this.
  Matrix operator*(const Matrix& other) const;
  /// Largest factor by which it stretches.
  double stretch() const;
  /// Factor by which the width of a line grows, as a mean over all directions.
  double mean_stretch() const;
  /// Whether it turns and scales equally in all directions, without a mirror.
  bool is_similarity() const;
  bool finite() const;
  /// Nothing if the matrix flattens, or if its inverse overflows.
  std::optional<Matrix> inverse() const;
};

/// Reads a text from its beginning.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  void skip_blanks();
  /// Blanks and at most one comma.
  void skip_separator();
  bool done();
  char peek() const { return text_.empty() ? '\0' : text_.front(); }
  char take();
  /// A number in the grammar of SVG: "1.5.5" and "1-2" are two numbers each.
  double number();
  bool at_number() const;
  /// A single 0 or 1, which need no separator.
  bool flag();
  std::string_view word();

 private:
  std::string_view text_;
};

inline constexpr std::string_view kBlanks = " \t\n\r\f";

/// The text less the blanks at its ends.
std::string_view trimmed(std::string_view text);

/// Throws std::invalid_argument: the text in quotes, and the cause.
[[noreturn]] void fail_value(std::string_view text, const std::string& cause);

/// All numbers of a list with blanks or commas.
std::vector<double> numbers(std::string_view text);

/// Lengths to which relative lengths refer, in user units.
struct Viewport {
  double width = 0, height = 0;            ///< lengths of 100%
  double em = 16, rem = 16;                ///< sizes of the fonts of the element and of the root
  double page_width = 0, page_height = 0;  ///< lengths of 100vw and 100vh
  double px_per_inch = 96;

  /// Length of 100% for percentages that are neither across nor down (SVG 2, 8.9).
  double diagonal() const { return std::hypot(width, height) / std::numbers::sqrt2; }
};

/// "12", "12px", "3mm", "1.5em", "10%" in user units; a percentage is of `whole`.
double length_px(std::string_view text, const Viewport& port, double whole);

/// A list of transforms, as an attribute, or with a viewport as a property of CSS, whose numbers have units.
Matrix transform(std::string_view text, const Viewport* port = nullptr);

/// A rotation about the origin, clockwise on the page.
Matrix turn(double degrees);

/// Degrees of an angle "90", "90deg", "1.5rad", "100grad" or "0.25turn"; nothing for any other text.
std::optional<double> angle_degrees(std::string_view text);

/// The point about which a transform is taken: "left 10px", "50% 50%", "center". Percentages refer to a box, given as a
/// matrix from the unit square.
Point2 transform_origin(std::string_view text, const Viewport& port, const Matrix& box);

/// A paint: nothing for "none" and "transparent", else the colour as "#rrggbb"; "currentColor" as it is written.
std::optional<std::string> paint(std::string_view text);

/// The opacity in a colour, "#rrggbbaa" or "rgb(1 2 3 / 50%)", from 0 to 1; 1 if it has none.
double color_opacity(std::string_view text);

/// The brightness of a colour as paint() gives it, 0 black to 1 white. An unknown name counts as black.
double brightness(const std::string& color);

}  // namespace ligne::svg
