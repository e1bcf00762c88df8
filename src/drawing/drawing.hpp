#pragma once
/// The drawing: named layers of polylines, text, and areas, in page millimetres.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/stroke.hpp"
#include "drawing/text_item.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Polylines as index arrays: polyline i has points [begin[i], begin[i + 1]). A closed polyline repeats its first point.
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

/// Puts the polylines of `from` behind those of `to`.
inline void append(Polylines& to, const Polylines& from) {
  const auto shift = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (std::size_t i = 1; i < from.begin.size(); ++i) to.begin.push_back(from.begin[i] + shift);
}

/// Layers of strokes, in the order in which they are painted: hidden strokes, those seen through transparent faces, then the
/// classes, the strongest last.
inline constexpr std::size_t kStrokeLayerCount = kLineClassCount + 2;
std::size_t stroke_layer(LineClass line_class, bool visible, unsigned level);
/// "hidden", "behind-glass", or the name of the class.
std::string_view stroke_layer_name(std::size_t layer);

/// A layer's name is also its id: those of strokes, "underside", "contour-base", "contour-index", "shore", "water", "text",
/// "debug", "hatch", "legend". Layers of one name that follow each other are one layer by objects, colours and widths.
struct Layer {
  std::string name;
  Polylines lines;
  std::string material{};  ///< name of the material, where the layer holds the lines of one material only
  unsigned shade = 0;      ///< hatching of one degree of darkness only: 1 the darkest; 0: of all
  std::string object{};    ///< name of the object, where the layer holds the lines of one object only
  std::optional<std::array<double, 3>> color{};  ///< of the lines, where it is not that of all lines
  std::optional<double> width_mm{};              ///< of the lines, where it is not that of all lines
  std::optional<double> height{};                ///< where the layer holds contour lines of one height only
};

/// An area of one colour.
struct Fill {
  std::vector<std::vector<Point2>> contours;  ///< page mm, not closed; what an odd number of them surrounds is filled
  std::array<double, 3> color{0, 0, 0};       ///< red, green, blue in [0, 1]
  double opacity = 1;
  bool overlaps = false;  ///< it may lie on other areas of its colour: it is painted by itself
};

/// Layers in the order in which they are painted, over the fills. Layers without lines are left out. Texts are painted last;
/// writers put them into a layer "text" in a typeface. A drawing has either texts or a layer "text" of lines
/// (plotting/stroke_text.hpp).
struct Drawing {
  std::vector<Layer> layers;
  std::vector<TextItem> texts{};
  std::vector<Fill> fills{};  ///< in the order in which they are painted
};

/// Every line once: where strokes lie on each other within `tolerance_mm` one of them stands for all (by class, then the
/// nearer, then the lower source). A hidden stroke gives way to every visible one, and one seen through transparent faces to
/// every one seen directly. Strokes whose `needs_overlap_check` is false are only compared with those where it is true.
/// Those that lie on no other keep their order; the others follow, by precedence.
void remove_coincident_strokes(StrokeModel& model, double tolerance_mm);

/// Joins strokes that continue each other into polylines, per layer. Where more than two strokes of a layer meet the
/// straightest continue each other.
Drawing make_drawing(const StrokeModel& model);

}  // namespace ligne
