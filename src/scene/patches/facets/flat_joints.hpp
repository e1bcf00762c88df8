#pragma once
/// Edges at which two faces lie in one plane, but for those where a surface goes over into one that bends otherwise.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/prefetch.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Least cosine between the normals of faces that may lie in one plane (2.6 degrees). Beyond it they do not, whatever
/// the precision.
inline constexpr double kFlatCosine = 0.999;

/// Whether a surface may be smooth across an edge, whatever its faces bend by.
inline bool may_be_smooth(const Topology& topology, std::uint32_t e) {
  constexpr std::uint16_t kNotSmooth = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeCrossing;
  return topology.edges[e].face1 != kNone && !(topology.edge_flags[e] & kNotSmooth);
}

/// The edges of an object at which two faces lie in one plane, as far as these two tell: indices from `edges.begin` on,
/// ascending. `normals` are those of face_normals(); `candidates` holds them among other edges of the topology, ascending,
/// as MeshAngles::flat does.
std::vector<std::uint32_t> flat_joints(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                                       std::span<const glm::vec3> normals, std::span<const std::uint32_t> candidates);

/// Prefetches for a loop over edges with two faces, in a scene of triangles: the corners of the faces at the edge that comes
/// kTurnsAhead iterations after the i-th, and where these are stored for one that comes as much later. The edges are those
/// of `numbers`, from `first` on.
[[gnu::always_inline]] inline void prefetch_faces_of(const Scene& scene, const Topology& topology,
                                                     std::span<const std::uint32_t> numbers, std::uint32_t first,
                                                     std::size_t i) {
  if (!scene.faces.all_triangles()) return;
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  if (i + 2 * kTurnsAhead < numbers.size()) {
    const Edge& edge = topology.edges[first + numbers[i + 2 * kTurnsAhead]];
    __builtin_prefetch(corners.data() + 3 * std::size_t{edge.face0});
    if (edge.face1 != kNone) __builtin_prefetch(corners.data() + 3 * std::size_t{edge.face1});
  }
  if (i + kTurnsAhead >= numbers.size()) return;
  const Edge& edge = topology.edges[first + numbers[i + kTurnsAhead]];
  prefetch(scene.vertices, corners.subspan(3 * std::size_t{edge.face0}, 3));
  if (edge.face1 != kNone) prefetch(scene.vertices, corners.subspan(3 * std::size_t{edge.face1}, 3));
}

/// Those of `joints` that are no inflections. The chords of two surfaces that are divided at equal angles leave their common
/// ruling at half of that angle. So where they bend to opposite sides, the strips on both sides of it lie in one plane,
/// though two surfaces meet there. Beyond both strips the facets bend alike, to opposite sides, at edges about parallel to
/// the ruling. `joints`: those of flat_joints(), indices from `first_edge` on. `normals` are those of face_normals(). O(log
/// n) for each.
std::vector<std::uint32_t> without_inflections(const Scene& scene, const Topology& topology, std::uint32_t first_edge,
                                               std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints);

}  // namespace ligne
