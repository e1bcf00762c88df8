#include "scene/patches/borders/tangent_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest relative difference between the radii of bands of one tube, and of the parts of a tube that were designed with
/// one radius.
constexpr double kTubePart = 0.03, kOneRadiusPart = 1e-3;
/// Largest distance of corners that lie on a surface exactly, in precisions of the coordinates or in sags.
constexpr double kExactPrecisions = 8, kExactSags = 0.002;

/// Least tangent part of the common border of two unlike surfaces that makes all of it tangent.
constexpr double kMostOfUnlike = 0.6;

enum class Family : std::uint8_t { none, flat, ruled, sphere, torus };

Family family_of(const Patches& patches, std::uint32_t face) {
  const std::uint32_t p = patches.patch_of[face];
  if (p == kNone) return patches.is_freeform[face] ? Family::none : Family::flat;
  switch (patches.list[p].surface.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
    case SurfaceKind::extruded:
      return Family::ruled;
    case SurfaceKind::sphere:
      return Family::sphere;
    case SurfaceKind::torus:
      return Family::torus;
    case SurfaceKind::revolved:
      break;
  }
  return Family::none;
}

/// Radius of the tube of which a face may be a band; 0 if it is none.
double tube_radius(const Patches& patches, std::uint32_t face) {
  const std::uint32_t p = patches.patch_of[face];
  if (p == kNone) return 0;
  const PatchSurface& surface = patches.list[p].surface;
  if (surface.kind == SurfaceKind::torus) return surface.tube;
  return surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::sphere ? surface.radius : 0;
}

bool is_cone(const Patches& patches, std::uint32_t face) {
  const std::uint32_t p = patches.patch_of[face];
  return p != kNone && patches.list[p].surface.kind == SurfaceKind::cone;
}

/// Whether the corners of a face lie on its surface exactly. Planes are no approximations.
bool is_exact(const Scene& scene, const Patches& patches, std::uint32_t face) {
  if (patches.patch_of[face] == kNone) return true;
  const Patch& patch = patches.list[patches.patch_of[face]];
  const auto corners = scene.faces.contour(face, 0);
  const double precision = scene.objects[object_of_vertex(scene, corners[0])].precision;
  const double most = std::max(kExactPrecisions * precision, kExactSags * patch.sag);
  return std::ranges::all_of(corners,
                             [&](std::uint32_t v) { return std::abs(patch.surface.distance(scene.vertices[v])) <= most; });
}

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

bool are_unlike(const Scene& scene, const Patches& patches, const Edge& edge) {
  const Family one = family_of(patches, edge.face0), other = family_of(patches, edge.face1);
  if (one == other || one == Family::none || other == Family::none) return false;
  const bool first_exact = is_exact(scene, patches, edge.face0), second_exact = is_exact(scene, patches, edge.face1);
  for (const std::uint32_t face : {edge.face0, edge.face1}) {
    if (is_cone(patches, face)) return !patches.list[patches.patch_of[face]].is_band && (first_exact || second_exact);
  }
  const double radius = tube_radius(patches, edge.face0);
  const double difference = std::abs(radius - tube_radius(patches, edge.face1));
  if (!(radius > 0) || difference > kTubePart * radius) return true;
  return difference <= kOneRadiusPart * radius && first_exact && second_exact;
}

void close_unlike_borders(const Scene& scene, const Topology& topology, const Patches& patches,
                          std::vector<PatchEdge>& edges) {
  if (patches.list.empty()) return;
  struct Lengths {
    double all = 0, tangent = 0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Lengths> borders;  // by two patches, the lower number first
  const auto pair_at = [&](std::size_t e) {
    const Edge& edge = topology.edges[e];
    return std::minmax({patches.patch_of[edge.face0], patches.patch_of[edge.face1]});
  };
  const std::vector<std::uint32_t> crossings = indices_where(edges.size(), [&](std::size_t e) {
    const Edge& edge = topology.edges[e];
    if (edges[e] != PatchEdge::inside || edge.face1 == kNone || (topology.edge_flags[e] & kEdgeSmooth)) return false;
    const auto [p, q] = pair_at(e);
    return p != q && q != kNone && are_unlike(scene, patches, edge);
  });
  for (const std::uint32_t e : crossings) borders[pair_at(e)];
  if (borders.empty()) return;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (topology.edges[e].face1 == kNone) continue;
    const auto [p, q] = pair_at(e);
    if (p == q || q == kNone) continue;
    const auto border = borders.find({p, q});
    if (border == borders.end()) continue;
    const double length = edge_length(scene, topology.edges[e]);
    border->second.all += length;
    if (edges[e] == PatchEdge::tangent) border->second.tangent += length;
  }
  for (const std::uint32_t e : crossings) {
    const Lengths& border = borders[pair_at(e)];
    if (border.tangent >= kMostOfUnlike * border.all) edges[e] = PatchEdge::tangent;
  }
}

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
