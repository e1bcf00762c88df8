#pragma once
/// The box around what is plotted, as the viewer sees it.

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// A straight line in model space, to be drawn where nothing hides it.
struct AxisLine {
  Point3 a, b;
};

/// A box along the axes of the model; low <= high in each of them.
struct AxesBox {
  Point3 low{0, 0, 0}, high{0, 0, 0};

  /// Corner i: bit k of i says whether its coordinate k is the high one.
  Point3 corner(unsigned i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
};

/// The edge along axis `axis` from corner `from`, whose bit `axis` is not set, to that where it is.
struct BoxEdge {
  unsigned axis = 0, from = 0;
  unsigned to() const { return from | 1u << axis; }
};

inline constexpr std::size_t kBoxEdges = 12;
std::array<BoxEdge, kBoxEdges> box_edges();

/// sides[k][0] and [k][1] are the low and the high side across axis k.
using BoxSides = std::array<std::array<bool, 2>, 3>;

/// The sides that are seen from within, behind what the box holds. In parallel projection one of each pair: where both are
/// seen edge on, the low one. In perspective both of a pair when the eye is between them.
BoxSides back_sides(const AxesBox& box, const Camera& camera);

/// The edge is one of a back side.
bool is_back(const BoxEdge& edge, const BoxSides& back);

/// The box as a scene of triangles, to place the camera and the page with.
Scene box_scene(const AxesBox& box);

}  // namespace ligne
