#pragma once
/// The drawing: named layers of polylines, texts, and filled areas. Coordinates are in page millimetres.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "drawing/text_item.hpp"
#include "geometry/point.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Polylines in one array: polyline i has the points [begin[i], begin[i + 1]). A closed polyline repeats its first
/// point.
struct Polylines {
  std::vector<Point2> points;
  std::vector<std::uint32_t> begin{0};

  std::size_t size() const { return begin.size() - 1; }
  std::span<const Point2> operator[](std::size_t i) const {
    return {points.data() + begin[i], points.data() + begin[i + 1]};
  }

  void add(std::span<const Point2> line) {
    points.insert(points.end(), line.begin(), line.end());
    begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
};

/// The length of a polyline, in its own units.
inline double path_length(std::span<const Point2> line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += glm::distance(line[i - 1], line[i]);
  return sum;
}

/// Whether a polyline returns to its first point.
inline bool is_loop(std::span<const Point2> line) { return line.size() > 2 && line.front() == line.back(); }

/// Appends the polylines of `from` to those of `to`.
inline void append(Polylines& to, const Polylines& from) {
  const auto shift = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (std::size_t i = 1; i < from.begin.size(); ++i) to.begin.push_back(from.begin[i] + shift);
}

/// Number of layers for strokes: hidden strokes, strokes behind transparent faces, and one layer per line class. They
/// are painted in this order, with the classes of highest precedence last.
inline constexpr std::size_t kStrokeLayerCount = kLineClassCount + 2;
/// Index of the layer of a stroke, from 0, in painting order. `level` is Stroke::level.
std::size_t stroke_layer(LineClass line_class, bool visible, unsigned level);
/// "hidden", "behind-glass" for strokes behind transparent faces, or the name of the line class.
std::string_view stroke_layer_name(std::size_t layer);

/// A set of polylines drawn in one style. Its name identifies it: one of stroke_layer_name(), "underside",
/// "contour-base", "contour-index", "shore", "water", "points", "text", "debug", "hatch" and "legend".
/// Successive layers with the same name are parts of one layer, divided by object, colour and width.
struct Layer {
  std::string name;
  Polylines lines;
  std::string material{};  ///< name of the material, if all lines belong to one material
  unsigned shade = 0;      ///< degree of darkness, 1 the darkest, if the layer is hatching of one degree; else 0
  std::string object{};    ///< name of the object, if all lines belong to one object
  /// Colour of the lines, components in [0, 1]; none: the layer's style decides.
  std::optional<std::array<double, 3>> color{};
  std::optional<double> width_mm{};  ///< of the lines; none: the layer's style decides
  std::optional<double> height{};    ///< height of the contour lines, if all have the same height
};

/// An area of one colour.
struct Fill {
  std::vector<std::vector<Point2>> contours;  ///< page mm, first point not repeated; filled by the even-odd rule
  std::array<double, 3> color{0, 0, 0};       ///< red, green, blue in [0, 1]
  double opacity = 1;
  bool overlaps = false;  ///< may overlap other areas of its colour, so it is painted separately
};

/// A picture of faces, stored row by row from the top; 0 is black, 255 white.
struct FacePicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> gray;   ///< a byte a pixel; empty if the picture has colours
  Point2 corner_mm{0, 0};           ///< position of its upper left corner on the page
  double pixel_mm = 0;              ///< side of a pixel on the page; 0: the pixels are those of a PNG page
  std::vector<std::uint8_t> rgb{};  ///< red, green, blue of each pixel; empty if the picture is gray

  bool empty() const { return gray.empty() && rgb.empty(); }
};

/// A drawing. Fills are painted first, then layers, then texts. A drawing has either `texts`, which writers put into a
/// layer "text" in a typeface, or a layer "text" of stroked characters (plotting/stroke_text.hpp).
struct Drawing {
  std::vector<Layer> layers;  ///< in painting order; each has lines
  std::vector<TextItem> texts{};
  std::vector<Fill> fills{};  ///< in painting order
};

/// Joins strokes with common ends into polylines, layer by layer. Where more than two strokes of a layer meet, the pair
/// that makes the straightest line is joined first.
Drawing make_drawing(const StrokeModel& model);

}  // namespace ligne
