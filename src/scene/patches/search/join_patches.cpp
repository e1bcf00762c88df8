#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/search/patch_finder.hpp"

namespace ligne {
namespace {

/// Adjustable. Largest distance, in sags, between the surface of a patch and the corners of a facet that joins it late.
/// Where faceted bodies were cut by each other, corners lie on chords, as far away as the largest sag, which for
/// triangles is 1.5 times the median one.
constexpr double kJoinedSags = 1.6;
/// Adjustable. Largest distance of the corners of a facet from a surface, as a fraction of that from another one, at which
/// it joins the nearer one alone.
constexpr double kBetterPart = 0.5;
/// Least cosine between the axis of a cylinder or cone and an edge along it.
constexpr double kAlongCosine = 0.7;
/// Least cosine between the normals of a triangle and of the surface on which its corners lie exactly.
constexpr double kSlantingCosine = 0.2;
/// Largest sag of a triangle that joins a patch with its corners exactly on the surface, in sags of the patch. Some
/// tessellators put triangles over the whole width of a fillet beside rows that divide it into seven.
constexpr double kExactSags = 50;
/// Largest distance, in sags, between the corners of a patch and the surface of a larger patch into which it is merged.
constexpr double kMergedSags = 0.5;
/// Largest sag of the facets of such a patch, in sags of the larger one, if its corners lie on that as exactly as those by
/// which it was found. Tessellators make rows at the border of a torus up to five times as wide as the others, and each row
/// by itself lies on a cone.
constexpr double kMergedRowSags = 25;

}  // namespace

/// Lets facets without a surface join the patches beside them.
void PatchFinder::join_borders(const std::vector<Patch>& patches) {
  trade_borders(patches);
  // Rows of a torus that is coarse round its axis and fine round its tube are tilted far from its normals.
  join_facets(patches, true);
  join_facets(patches, false);
  trade_borders(patches);
}

/// Per patch, whether it lies beside another piece of the same bent tube.
std::vector<std::uint8_t> PatchFinder::tube_pieces(const std::vector<Patch>& patches) const {
  std::vector<std::uint8_t> is_piece(patches.size(), 0);
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    const std::uint32_t p = patch_of_[f];
    if (p == kNone || is_piece[p]) continue;
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      const std::uint32_t q = patch_of_[arc.facet];
      if (q != kNone && q != p && are_tube_pieces(patches[p].surface, patches[q].surface)) is_piece[p] = 1;
    }
  }
  return is_piece;
}

/// Joins facets to the patches beside them. `exact`: only facets whose corners lie on the surface within the precision of
/// the coordinates: triangles with nearly any normal (kSlantingCosine), and polygons, such as the flat ring at the top of a
/// torus, with nearly that of the surface; otherwise facets near the surface with nearly its normal.
void PatchFinder::join_facets(const std::vector<Patch>& patches, bool exact) {
  std::vector<std::uint32_t> reached;
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) reached.push_back(f);
  }
  // Such pieces are approximations, which facets of the tube leave to both sides.
  const std::vector<std::uint8_t> is_piece = exact ? std::vector<std::uint8_t>{} : tube_pieces(patches);
  const auto try_to_join = [&](std::uint32_t from, std::uint32_t f, std::uint32_t edge) {
    const std::size_t corners = graph_.vertices[f].size();
    if (patch_of_[f] != kNone || (exact && corners == 4)) return;
    const Patch& patch = patches[patch_of_[from]];
    const bool may_slant = exact && corners == 3;
    double tolerance = exact ? tolerance_for(patch.surface.kind, 0) : kJoinedSags * patch.sag;
    double most_sags = may_slant ? kExactSags : kMostSags;
    if (is_fillet(patch_of_[from])) {
      if (is_in_disc(patch, f)) return;
      if (exact) tolerance = std::max(tolerance, kStripSagPart * patch.sag);
      most_sags = kMostSags;
    }
    if (!lies_on(patch, f, tolerance, may_slant ? kSlantingCosine : kNormalCosine, most_sags)) return;
    if (!exact && !is_piece[patch_of_[from]] && !is_along(patch.surface, edge) && !lies_on_chords(patch, f)) return;
    patch_of_[f] = patch_of_[from];
    reached.push_back(f);
  };
  std::size_t next = 0;
  const auto grow_over_arcs = [&] {
    for (; next < reached.size(); ++next) {
      const std::uint32_t from = reached[next];
      forget_looks();
      for (const FacetGraph::Arc& arc : graph_.arcs_of(from)) try_to_join(from, arc.facet, arc.edge);
    }
  };
  grow_over_arcs();
  if (!exact) return;
  for (const auto& [a, b] : graph_.steep) {
    forget_looks();
    if (patch_of_[a] != kNone) try_to_join(a, b, kNone);
    if (patch_of_[b] != kNone) try_to_join(b, a, kNone);
  }
  grow_over_arcs();
}

/// Largest distance of a corner of a facet from a surface.
double PatchFinder::distance_of(const PatchSurface& surface, std::uint32_t f) const {
  double most = 0;
  for (const std::uint32_t v : graph_.vertices[f]) most = std::max(most, std::abs(surface.distance(scene_.vertices[v])));
  return most;
}

/// Gives facets that lie on their patch within its tolerance alone to patches beside them on which they lie better. Where a
/// surface begins to leave a tangent one, its first row lies near that one, which may have been found before it.
void PatchFinder::trade_borders(const std::vector<Patch>& patches) {
  std::vector<std::uint32_t> reached;
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) reached.push_back(f);
  }
  // Each facet that moves comes nearer to its surface by a factor, so this ends.
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::uint32_t q = patch_of_[reached[i]];
    for (const FacetGraph::Arc& arc : graph_.arcs_of(reached[i])) {
      const std::uint32_t f = arc.facet, p = patch_of_[f];
      if (p == kNone || p == q) continue;
      const double here = distance_of(patches[p].surface, f);
      if (here <= tolerance_for(patches[p].surface.kind, 0)) continue;
      const double there = distance_of(patches[q].surface, f);
      if (there > tolerance_for(patches[q].surface.kind, 0) || there >= kBetterPart * here) continue;
      forget_looks();
      if (!lies_on(patches[q], f, kJoinedSags * patches[q].sag)) continue;
      patch_of_[f] = q;
      reached.push_back(f);
    }
  }
}

/// Whether an edge of a cylinder or a cone has about the direction of its axis. Strips go on across such edges, and programs
/// approximate the curves at which these end.
bool PatchFinder::is_along(const PatchSurface& surface, std::uint32_t edge) const {
  if (surface.kind != SurfaceKind::cylinder && surface.kind != SurfaceKind::cone) return false;
  const Point3 way = scene_.vertices[topology_.edges[edge].v1] - scene_.vertices[topology_.edges[edge].v0];
  return std::abs(glm::dot(way, surface.axis)) >= kAlongCosine * glm::length(way);
}

/// Whether the corners of a facet near a surface may lie on its chords. Those of a surface without saddles lie towards its
/// axis: on the other side are the corners of the first row of a hollow fillet.
bool PatchFinder::lies_on_chords(const Patch& patch, std::uint32_t f) const {
  const PatchSurface& surface = patch.surface;
  if (surface.kind == SurfaceKind::torus) return true;
  const double tolerance = tolerance_for(surface.kind, patch.sag);
  return std::ranges::all_of(graph_.vertices[f],
                             [&](std::uint32_t v) { return surface.distance(scene_.vertices[v]) <= tolerance; });
}

/// Merges adjacent patches if the facets by which the smaller one was found lie on the surface of the larger one.
/// `found_by`: per facet, its patch before join_borders(). Returns whether any patches were merged.
bool PatchFinder::merge_patches(const std::vector<Patch>& patches, const std::vector<std::uint32_t>& found_by) {
  std::vector<std::vector<std::uint32_t>> facets(patches.size()), core(patches.size());
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) facets[patch_of_[f]].push_back(f);
    if (found_by[f] != kNone) core[found_by[f]].push_back(f);
  }
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](std::uint32_t l, std::uint32_t r) { return facets[l].size() > facets[r].size(); });
  bool is_merged = false;
  const auto try_to_merge = [&](std::uint32_t p, std::uint32_t q) {
    if (p == kNone || q == kNone || q == p || facets[q].size() > facets[p].size()) return;
    const PatchSurface& surface = patches[p].surface;
    const auto lie_on_p = [&](double tolerance, double most_sags) {
      forget_looks();
      return std::ranges::all_of(
          core[q], [&](std::uint32_t f) { return lies_on(patches[p], f, tolerance, kSlantingCosine, most_sags); });
    };
    if (!lie_on_p(kMergedSags * patches[p].sag, kMostSags) &&
        !lie_on_p(tolerance_for(surface.kind, patches[p].sag), kMergedRowSags))
      return;
    for (const std::uint32_t f : facets[q]) patch_of_[f] = p;
    facets[p].insert(facets[p].end(), facets[q].begin(), facets[q].end());
    facets[q].clear();
    is_merged = true;
  };
  for (const std::uint32_t p : order) {
    forget_looks();
    for (std::size_t i = 0; i < facets[p].size(); ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[p][i])) try_to_merge(p, patch_of_[arc.facet]);
    }
  }
  for (const auto& [a, b] : graph_.steep) {
    for (const auto& [p, q] : {std::pair(patch_of_[a], patch_of_[b]), std::pair(patch_of_[b], patch_of_[a])}) {
      forget_looks();
      try_to_merge(p, q);
    }
  }
  return is_merged;
}

}  // namespace ligne
