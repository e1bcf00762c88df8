#include "scene/patches/borders/flat_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest distance of corners from the surface, in precisions of the coordinates.
constexpr double kPrecisions = 8;
/// Largest ratio between the sags of a face and of the facets of its surface: that at which surfaces grow.
constexpr double kMostRowSags = 4;
/// Largest relative difference between the radii of two pieces of one surface.
constexpr double kLikeRadius = 0.01;

bool lies_on(const Scene& scene, std::uint32_t face, const Patch& patch, double precision) {
  const auto corners = scene.faces.contour(face, 0);
  Point3 middle(0.0);
  for (const std::uint32_t v : corners) {
    if (std::abs(patch.surface.distance(scene.vertices[v])) > kPrecisions * precision) return false;
    middle += scene.vertices[v] / static_cast<double>(corners.size());
  }
  return std::abs(patch.surface.distance(middle)) <= kMostRowSags * patch.sag;
}

/// Whether two patches on which one face lies are pieces of one surface, which the plane of that face has parted. Those of
/// an S-shaped wall bend to opposite sides there.
bool are_pieces(const Patch& p, const Patch& q) {
  const auto is_like = [](double a, double b) {
    return std::abs(a - b) <= kLikeRadius * std::max(std::abs(a), std::abs(b));
  };
  return p.surface.kind == q.surface.kind && p.outward == q.outward && is_like(p.surface.radius, q.surface.radius) &&
         is_like(p.surface.tube, q.surface.tube);
}

}  // namespace

void assign_flat_rows(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                      std::span<const Patch> patches, std::vector<std::uint32_t>& patch_of) {
  const std::uint32_t first = object.face_begin;
  DisjointSets pieces(patches.size());
  bool has_pieces = false;
  for (std::uint32_t f = 0; f < graph.size(); ++f) {
    const auto faces = graph.faces[f];
    if (!graph.is_plane[f] || patch_of[faces[0] - first] != kNone) continue;
    std::size_t assigned = 0;
    std::vector<std::array<std::uint32_t, 2>> parted;
    for (const FacetGraph::Arc& arc : graph.arcs_of(f)) {
      const std::uint32_t patch = patch_of[graph.faces[arc.facet][0] - first];
      if (patch == kNone) continue;
      const Edge& edge = topology.edges[arc.edge];
      const std::uint32_t face = graph.facet_of[edge.face0 - first] == f ? edge.face0 : edge.face1;
      // A row of a tube meets the next piece of the tube at its end, and does not lie on it.
      if (!lies_on(scene, face, patches[patch], object.precision)) continue;
      std::uint32_t& own = patch_of[face - first];
      assigned += own == kNone;
      if (own == kNone) own = patch;
      if (own != patch && are_pieces(patches[own], patches[patch])) parted.push_back({own, patch});
    }
    if (assigned == faces.size()) {
      for (const auto& [p, q] : parted) pieces.join(p, q);
      has_pieces = has_pieces || !parted.empty();
      continue;
    }
    for (const std::uint32_t face : faces) patch_of[face - first] = kNone;
  }
  if (!has_pieces) return;
  for (std::uint32_t& patch : patch_of)
    if (patch != kNone) patch = pieces.find(patch);
}

}  // namespace ligne
