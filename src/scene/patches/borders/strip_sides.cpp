#include "scene/patches/borders/strip_sides.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/model/object_sizes.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

/// Adjustable. For the side of a strip of a cylinder: largest sine of its angle to the axis (1 degree), and least ratio
/// of its length to the width of the face beside it.
constexpr double kStripSine = 0.0175, kStripLength = 4;
/// Adjustable. As kStripLength, for the first row of a free form beside a plane: decimated meshes have faces four times as
/// long as wide by accident.
constexpr double kRowLength = 16;

/// Whether an edge is so many times as long as a face beside it is wide.
bool is_long_beside(const Scene& scene, const Edge& edge, std::uint32_t face, double times) {
  const Point3 &from = scene.vertices[edge.v0], along = scene.vertices[edge.v1] - from;
  const double squared = glm::dot(along, along);
  // The length of the cross product is the edge's length times the distance of the corner from its line.
  return std::ranges::all_of(scene.faces.contour(face, 0), [&](std::uint32_t v) {
    return times * glm::length(glm::cross(along, scene.vertices[v] - from)) <= squared;
  });
}

}  // namespace

bool is_of_strip(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e) {
  if (topology.edge_flags[e] & kEdgeSmooth) return false;
  const Edge& edge = topology.edges[e];
  const Point3 along = scene.vertices[edge.v1] - scene.vertices[edge.v0];
  const auto is_strip = [&](std::uint32_t face) {
    const std::uint32_t p = patches.patch_of[face];
    if (p == kNone || patches.list[p].surface.kind != SurfaceKind::cylinder) return false;
    const double sine = glm::length(glm::cross(along, patches.list[p].surface.axis));
    return sine * sine <= kStripSine * kStripSine * glm::dot(along, along) &&
           is_long_beside(scene, edge, face, kStripLength);
  };
  return is_strip(edge.face0) || is_strip(edge.face1);
}

bool is_of_row_at_plane(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e) {
  const Edge& edge = topology.edges[e];
  if (edge.face1 == kNone || patches.is_freeform[edge.face0] == patches.is_freeform[edge.face1]) return false;
  const bool first = patches.is_freeform[edge.face0] != 0;
  const std::uint32_t row = first ? edge.face0 : edge.face1, plane = first ? edge.face1 : edge.face0;
  return patches.patch_of[plane] == kNone && is_long_beside(scene, edge, row, kRowLength) &&
         is_part(scene, patches, scene.objects[object_of_vertex(scene, edge.v0)]);
}

}  // namespace ligne
