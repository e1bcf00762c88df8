#include "scene/patches/borders/flat_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest distance of corners from the surface, in precisions of the coordinates or in sags, if that is more.
constexpr double kPrecisions = 8, kRowSagPart = 0.01;
/// Largest ratio between the sags of a face and of the facets of its surface: that at which surfaces grow.
constexpr double kMostRowSags = 4;
/// Largest relative difference between the radii of two pieces of one surface.
constexpr double kLikeRadius = 0.01;
/// Most faces of a facet that rounding has made of rows of two surfaces, or of a row and another face in its plane, and
/// least part of its area that the rows take.
constexpr std::size_t kMostMixedFaces = 8;
constexpr double kMostOfMixed = 0.5;
/// Most corners of a facet that is one row.
constexpr std::size_t kRowCorners = 4;

bool lies_on(const Scene& scene, std::uint32_t face, const Patch& patch, double precision) {
  const auto corners = scene.faces.contour(face, 0);
  const double most = std::max(kPrecisions * precision, kRowSagPart * patch.sag);
  Point3 middle(0.0);
  for (const std::uint32_t v : corners) {
    if (std::abs(patch.surface.distance(scene.vertices[v])) > most) return false;
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

/// Gives the faces of facets to the patches beside them.
class FlatRows {
 public:
  FlatRows(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
           std::span<const Patch> patches, std::vector<std::uint32_t>& patch_of)
      : scene_(scene), topology_(topology), object_(object), graph_(graph), patches_(patches), patch_of_(patch_of) {}

  /// Takes the faces of a facet from its patch that do not lie on it. Returns whether there are any.
  bool release(std::uint32_t f) {
    if (graph_.vertices[f].size() <= kRowCorners) return false;
    const std::uint32_t patch = patch_of(graph_.faces[f][0]);
    if (patches_[patch].surface.profile) return false;
    bool has_any = false;
    for (const std::uint32_t face : graph_.faces[f]) {
      if (lies_on(scene_, face, patches_[patch], object_.precision)) continue;
      patch_of(face) = kNone;
      has_any = true;
    }
    return has_any;
  }

  /// Assigns the faces of a facet that have no patch, where they lie on one beside it.
  void assign(std::uint32_t f) {
    parted_.clear();
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      const std::uint32_t patch = patch_of(graph_.faces[arc.facet][0]);
      if (patch == kNone) continue;
      const Edge& edge = topology_.edges[arc.edge];
      const std::uint32_t face = graph_.facet_of[edge.face0 - object_.face_begin] == f ? edge.face0 : edge.face1;
      // A row of a tube meets the next piece of the tube at its end, and does not lie on it.
      if (!lies_on(scene_, face, patches_[patch], object_.precision)) continue;
      const std::uint32_t own = patch_of(face);
      if (own == kNone) patch_of(face) = patch;
      if (own != kNone && own != patch && are_pieces(patches_[own], patches_[patch])) parted_.push_back({own, patch});
    }
    if (graph_.faces[f].size() <= kMostMixedFaces) spread(f);
  }

  bool is_assigned(std::uint32_t f) const {
    return std::ranges::none_of(graph_.faces[f], [&](std::uint32_t face) { return patch_of(face) == kNone; });
  }

  /// The pairs of patches that the last facet has parted.
  std::span<const std::array<std::uint32_t, 2>> parted() const { return parted_; }

  /// Whether the faces of a facet that were assigned take most of its area.
  bool is_mixed(std::uint32_t f) const {
    double all = 0, area = 0;
    for (const std::uint32_t face : graph_.faces[f]) {
      const double part = glm::length(double_area(scene_, face));
      all += part;
      if (patch_of(face) != kNone) area += part;
    }
    return graph_.faces[f].size() <= kMostMixedFaces && area >= kMostOfMixed * all;
  }

 private:
  std::uint32_t& patch_of(std::uint32_t face) const { return patch_of_[face - object_.face_begin]; }

  /// Goes on to the faces behind those that were assigned.
  void spread(std::uint32_t f) {
    for (bool changes = true; changes;) {
      changes = false;
      for (const std::uint32_t face : graph_.faces[f]) {
        if (patch_of(face) != kNone) continue;
        patch_of(face) = patch_beside(face, f);
        changes |= patch_of(face) != kNone;
      }
    }
  }

  /// The patch of another face of the same facet on which a face lies as well, or kNone.
  std::uint32_t patch_beside(std::uint32_t face, std::uint32_t f) const {
    const auto corners = scene_.faces.contour(face, 0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Edge* edge = find_edge(topology_, {corners[k], corners[k + 1 == corners.size() ? 0 : k + 1]});
      if (!edge || edge->face1 == kNone) continue;
      const std::uint32_t other = other_face(*edge, face);
      if (graph_.facet_of[other - object_.face_begin] != f || patch_of(other) == kNone) continue;
      if (lies_on(scene_, face, patches_[patch_of(other)], object_.precision)) return patch_of(other);
    }
    return kNone;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  const FacetGraph& graph_;
  std::span<const Patch> patches_;
  std::vector<std::uint32_t>& patch_of_;
  std::vector<std::array<std::uint32_t, 2>> parted_;
};

}  // namespace

void assign_flat_rows(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                      const FaceSurfaces& surfaces) {
  const auto& [patches, patch_of, is_freeform] = surfaces;
  const std::uint32_t first = object.face_begin;
  DisjointSets pieces(patches.size());
  bool has_pieces = false;
  FlatRows rows(scene, topology, object, graph, patches, patch_of);
  for (std::uint32_t f = 0; f < graph.size(); ++f) {
    const auto faces = graph.faces[f];
    const bool may_be_mixed = faces.size() > 1 && faces.size() <= kMostMixedFaces;
    const std::uint32_t before = patch_of[faces[0] - first];
    if (before == kNone ? !graph.is_plane[f] && !may_be_mixed : !may_be_mixed || !rows.release(f)) continue;
    rows.assign(f);
    const bool is_whole = rows.is_assigned(f);
    if (is_whole) {
      for (const auto& [p, q] : rows.parted()) pieces.join(p, q);
      has_pieces = has_pieces || !rows.parted().empty();
    }
    const bool stays = is_whole || (before == kNone && rows.is_mixed(f));
    for (const std::uint32_t face : faces) {
      if (!stays) patch_of[face - first] = before;
      if (stays) is_freeform[face - first] = patch_of[face - first] == kNone;
    }
  }
  if (!has_pieces) return;
  for (std::uint32_t& patch : patch_of)
    if (patch != kNone) patch = pieces.find(patch);
}

}  // namespace ligne
