#pragma once
/// The page, its pens and line styles.

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stroke.hpp"
#include "geometry/point.hpp"

namespace ligne {

inline constexpr double kMmPerInch = 25.4;
/// The longest side of a page: the numbers of a larger one would no longer be right to a micrometre in the output formats.
inline constexpr double kLargestPageMm = 100'000;

struct Page {
  double width_mm = 210;
  double height_mm = 297;
  double margin_mm = 10;

  Rect sheet() const { return {{0, 0}, {width_mm, height_mm}}; }
  /// The sheet less its margins.
  Rect drawable() const { return {{margin_mm, margin_mm}, {width_mm - margin_mm, height_mm - margin_mm}}; }
};

/// "12", "12mm", "1.5cm", "0.5in", "72pt" in millimetres; a bare number is millimetres. Throws std::invalid_argument with
/// one line for anything else, for what is not finite and for what is negative.
double parse_length_mm(std::string_view text);

/// "A0" to "A6", "letter", "legal", "tabloid" (any case, portrait), or "WxH" with units ("100x150", "10cmx15cm",
/// "8inx10in"). The margin is left as it is. Throws std::invalid_argument.
Page parse_page(std::string_view text);

/// How the lines of one layer are drawn.
struct LineStyle {
  double width_mm = 0.35;
  std::array<double, 3> color{0, 0, 0};
  std::vector<double> dashes_mm;  ///< empty: solid
};

/// Widths of layers by their names, mm.
using LineWidths = std::map<std::string, double, std::less<>>;

/// The style at another width: dashes are told in widths.
LineStyle with_width(LineStyle style, double width_mm);

/// Style of the layer of that name at the given pen width: profiles 1.4 (one step up in the series of ISO 128-2), outlines
/// and borders full width, intersections, creases and lines of the shape 0.7 (one step down, so that profiles are twice as
/// wide as creases), tangent, mesh and shadow 0.5, behind-glass 0.5 and grey, hidden 0.5 and dashed (ISO 128-2: dash 12 d,
/// gap 3 d) unless `hidden_solid`.
LineStyle layer_style(std::string_view layer, double pen_width_mm, bool hidden_solid);

}  // namespace ligne
