#pragma once
/// The edges of the box on which the scales stand.

#include <array>
#include <optional>

#include "view/axes/axes_box.hpp"

namespace ligne {

/// An edge of the box that is one of the outline of its picture.
struct AxisEdge {
  unsigned axis = 0, corner = 0;  ///< as BoxEdge
  Point2 a{0, 0}, b{0, 0};        ///< page mm, the part in view, from low to high
  Point2 outward{0, 0};           ///< unit vector across it, away from the picture
};

/// One of each axis, or none.
using AxisEdges = std::array<std::optional<AxisEdge>, 3>;

/// Chooses for x and y edges low on the page, for z one at the left; none shorter than two heights of the text, and none
/// that lies in another's way. None at all when the box reaches behind the near plane.
AxisEdges choose_axis_edges(const AxesBox& box, const View& view, double text_height_mm);

}  // namespace ligne
