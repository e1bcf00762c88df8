#include "scene/patches/borders/patch_outlines.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {
namespace {

/// Adjustable: largest angle, in degrees, between the normals of a surface and of a plane that it runs into.
constexpr double kTangentDegrees = 1;

}  // namespace

std::vector<PatchOutline> patch_outlines(const Scene& scene, std::span<const Edge> edges, const Object& object,
                                         const FacetGraph& graph, const FacetSurfaces& surfaces) {
  const auto& [patches, patch_of, is_freeform] = surfaces;
  std::vector<PatchOutline> outlines(patches.size());
  for (const std::uint32_t p : patch_of) {
    if (p != kNone) ++outlines[p].facets;
  }
  const double smooth = sine_cosine_degrees(kLargestBend).cosine;
  const double tangent = sine_cosine_degrees(kTangentDegrees).cosine;
  for (const Edge& edge : edges) {
    if (edge.face1 == kNone) continue;
    const std::uint32_t a = graph.facet_of[edge.face0 - object.face_begin],
                        b = graph.facet_of[edge.face1 - object.face_begin];
    if (patch_of[a] == patch_of[b]) continue;
    const double length = edge_length(scene, edge);
    const bool is_smooth = glm::dot(graph.frames[a].normal, graph.frames[b].normal) >= smooth;
    for (const auto& [here, there] : {std::pair{a, b}, std::pair{b, a}}) {
      if (patch_of[here] == kNone) continue;
      PatchOutline& outline = outlines[patch_of[here]];
      outline.length += length;
      if (is_smooth && patch_of[there] == kNone && !is_freeform[there]) {
        const Point3 middle = 0.5 * (scene.vertices[edge.v0] + scene.vertices[edge.v1]);
        const double cosine = glm::dot(patches[patch_of[here]].surface.normal(middle), graph.frames[there].normal);
        if (std::abs(cosine) >= tangent) outline.into_planes += length;
      }
      if (is_smooth && patch_of[there] != kNone)
        outline.is_piece |= are_tube_pieces(patches[patch_of[here]].surface, patches[patch_of[there]].surface);
      if (is_smooth && is_freeform[there]) outline.into_freeform += length;
      if (is_smooth && (is_freeform[there] || patch_of[there] != kNone)) outline.into_curved += length;
    }
  }
  return outlines;
}

}  // namespace ligne
