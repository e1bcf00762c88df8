#include "scene/patches/borders/flat_rows.hpp"

#include <algorithm>
#include <cmath>

#include "base/no_index.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest distance of corners from the surface, in precisions of the coordinates.
constexpr double kPrecisions = 8;
/// Largest ratio between the sags of a face and of the facets of its surface.
constexpr double kMostRowSags = 2;

bool lies_on(const Scene& scene, std::uint32_t face, const Patch& patch, double precision) {
  const auto corners = scene.faces.contour(face, 0);
  Point3 middle(0.0);
  for (const std::uint32_t v : corners) {
    if (std::abs(patch.surface.distance(scene.vertices[v])) > kPrecisions * precision) return false;
    middle += scene.vertices[v] / static_cast<double>(corners.size());
  }
  return std::abs(patch.surface.distance(middle)) <= kMostRowSags * patch.sag;
}

}  // namespace

void assign_flat_rows(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                      std::span<const Patch> patches, std::vector<std::uint32_t>& patch_of) {
  const std::uint32_t first = object.face_begin;
  for (std::uint32_t f = 0; f < graph.size(); ++f) {
    const auto faces = graph.faces[f];
    if (!graph.is_plane[f] || patch_of[faces[0] - first] != kNone) continue;
    std::size_t assigned = 0;
    const bool is_row = std::ranges::all_of(graph.arcs_of(f), [&](const FacetGraph::Arc& arc) {
      const std::uint32_t patch = patch_of[graph.faces[arc.facet][0] - first];
      if (patch == kNone) return true;
      const Edge& edge = topology.edges[arc.edge];
      const std::uint32_t face = graph.facet_of[edge.face0 - first] == f ? edge.face0 : edge.face1;
      if (!lies_on(scene, face, patches[patch], object.precision)) return false;
      assigned += patch_of[face - first] == kNone;
      patch_of[face - first] = patch;
      return true;
    });
    if (is_row && assigned == faces.size()) continue;
    for (const std::uint32_t face : faces) patch_of[face - first] = kNone;
  }
}

}  // namespace ligne
