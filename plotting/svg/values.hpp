#pragma once
/// The values of SVG attributes: numbers, lengths, transforms. Private to plotting.
///
/// Every reader throws std::invalid_argument with a phrase when the text has no meaning.

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
  /// First `other`, then this.
  Matrix operator*(const Matrix& other) const;
  /// Largest factor by which it stretches.
  double stretch() const;
  /// By how much a line's width grows, over all directions.
  double mean_stretch() const;
  /// Turns and scales alike in all directions, without a mirror.
  bool is_similarity() const;
  bool finite() const;
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
  /// A number in the grammar of SVG: "1.5.5" are two, "1-2" too.
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

/// All numbers of a list with blanks or commas.
std::vector<double> numbers(std::string_view text);

/// "12", "12px", "3mm" in CSS pixels of 1/96 in. A percentage is of `whole`, "em" and "ex" are of `em`, where there is one.
double length_px(std::string_view text, std::optional<double> whole = std::nullopt, std::optional<double> em = std::nullopt);

/// A list of transforms.
Matrix transform(std::string_view text);

/// A paint: nothing for "none" and "transparent", else the colour as "#rrggbb"; "currentColor" as it is written.
std::optional<std::string> paint(std::string_view text);

/// Of a colour as paint() gives it, 0 black to 1 white. One that is only a name is black.
double brightness(const std::string& color);

inline constexpr double kMmPerPx = kMmPerInch / 96;

}  // namespace ligne::svg
