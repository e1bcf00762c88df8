#pragma once
/// Chooses the edges of the box that carry the scales.

#include <array>
#include <optional>

#include "view/axes/axes_box.hpp"

namespace ligne {

/// An edge of the box on the outline of its picture.
struct AxisEdge {
  unsigned axis = 0, corner = 0;  ///< as in BoxEdge
  Point2 a{0, 0}, b{0, 0};        ///< page mm; ends of the visible part, from low to high
  Point2 outward{0, 0};           ///< unit vector perpendicular to it, away from the picture
};

/// One edge per axis, or none.
using AxisEdges = std::array<std::optional<AxisEdge>, 3>;

/// Chooses edges low on the page for x and y, and one at the left for z. None is shorter than two text heights, and
/// none is in another's way. There are none if the box reaches behind the near plane.
AxisEdges choose_axis_edges(const AxesBox& box, const View& view, double text_height_mm);

}  // namespace ligne
