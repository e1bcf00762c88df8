#pragma once
/// The box around the plotted objects, as the viewer sees it.

#include <array>
#include <cstddef>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// A straight line in model space, drawn where nothing hides it.
struct AxisLine {
  Point3 a, b;
};

/// A box along the axes of the model; low <= high on each axis.
struct AxesBox {
  Point3 low{0, 0, 0}, high{0, 0, 0};

  /// Corner i: bit k of i says whether its coordinate k is the high one.
  Point3 corner(unsigned i) const { return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; }
};

/// The edge along axis `axis` from corner `from`, whose bit `axis` is 0, to the corner where it is 1.
struct BoxEdge {
  unsigned axis = 0, from = 0;
  unsigned to() const { return from | 1u << axis; }
};

inline constexpr std::size_t kBoxEdges = 12;
std::array<BoxEdge, kBoxEdges> box_edges();

/// Marks of sides: [k][0] and [k][1] are the low and the high side across axis k.
using BoxSides = std::array<std::array<bool, 2>, 3>;

/// The sides seen from inside, behind the contents of the box. In parallel projection these are one of each pair; if
/// both are seen edge on, the low one. In perspective they are both of a pair if the eye is between them.
BoxSides back_sides(const AxesBox& box, const Camera& camera);

/// Whether the edge belongs to a back side.
bool is_back(const BoxEdge& edge, const BoxSides& back);

/// The box as a scene of triangles, for placing the camera and the page.
Scene box_scene(const AxesBox& box);

}  // namespace ligne
