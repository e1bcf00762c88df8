#pragma once
/// The page, lengths with units, and line styles.

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "linework/stroke.hpp"

namespace ligne {

inline constexpr double kMmPerInch = 25.4;
/// Longest side of a page. Coordinates on a larger page would not be exact to a micrometre in the output formats.
inline constexpr double kLargestPageMm = 100'000;

/// A sheet of paper. The origin of page coordinates is its top left corner.
struct Page {
  double width_mm = 210;
  double height_mm = 297;
  double margin_mm = 10;

  Rect sheet() const { return {{0, 0}, {width_mm, height_mm}}; }
  /// The sheet less its margins.
  Rect drawable() const { return {{margin_mm, margin_mm}, {width_mm - margin_mm, height_mm - margin_mm}}; }
};

/// Parses a length such as "12", "12mm", "1.5cm", "0.5in", "72pt" and returns millimetres; a bare number is
/// millimetres. Throws std::invalid_argument with a message of one line for other text, and for numbers that are
/// negative or not finite.
double parse_length_mm(std::string_view text);

/// Parses a page size: "A0" to "A6", "letter", "legal", "tabloid" (in any case; portrait), or "WxH" with units
/// ("100x150", "10cmx15cm", "8inx10in"). The margin of the result is the default. Throws std::invalid_argument.
Page parse_page(std::string_view text);

/// How the lines of one layer are drawn.
struct LineStyle {
  double width_mm = 0.35;
  std::array<double, 3> color{0, 0, 0};  ///< red, green, blue in [0, 1]
  std::vector<double> dashes_mm;         ///< lengths of dash, gap, dash, gap ...; empty: solid
};

/// Line widths by layer name, mm.
using LineWidths = std::map<std::string, double, std::less<>>;

/// The style at another width. Dash lengths scale with the width.
LineStyle with_width(LineStyle style, double width_mm);

/// Default style of the layer of that name. Its width is the pen width times a factor from the series of ISO 128-2:
/// - profiles: 1.4, one step above the pen;
/// - outlines and borders: 1;
/// - intersections, creases, suggestive contours, ridges and valleys: 0.7, one step below, half of a profile;
/// - tangent, mesh and shadow: 0.5;
/// - behind-glass: 0.5, grey;
/// - hidden: 0.5, dashed as in ISO 128-2 (dash 12 d, gap 3 d, for the line width d) unless `hidden_solid`.
LineStyle layer_style(std::string_view layer, double pen_width_mm, bool hidden_solid);

/// Width of the rim that opaque areas get in their own colour, mm. Renderers blend the paper in along the border of
/// every area, so paper would show between two areas that meet. The rim is wide enough to close the seams at 150 dpi,
/// and narrower than any line.
inline constexpr double kFillRimMm = 0.15;

}  // namespace ligne
