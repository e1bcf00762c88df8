#include <algorithm>
#include <numeric>

#include "base/no_index.hpp"
#include "scene/patches/patch_finder.hpp"

namespace ligne {
namespace {

/// Adjustable: sags by which corners of a facet that joins a patch late may lie beside its surface. Where bodies of facets
/// were cut by each other, corners lie on the chords, up to the largest sag, which is 1.5 times the median one of triangles.
constexpr double kJoinedSags = 1.6;
/// Sags by which corners of a patch may lie beside the surface of another one that it becomes part of.
constexpr double kMergedSags = 0.2;

}  // namespace

/// Facets without a surface beside a patch join it.
void PatchFinder::join_borders(const std::vector<Patch>& patches) {
  std::vector<std::uint32_t> reached;
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) reached.push_back(f);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Patch& patch = patches[patch_of_[reached[i]]];
    forget_looks();
    for (const FacetGraph::Arc& arc : graph_.arcs_of(reached[i])) {
      if (patch_of_[arc.facet] != kNone) continue;
      if (!lies_on(patch, arc.facet, kJoinedSags * patch.sag)) continue;
      patch_of_[arc.facet] = patch_of_[reached[i]];
      reached.push_back(arc.facet);
    }
  }
}

/// Patches that touch become one where the facets of the smaller one that it was found by lie on the surface of the larger.
/// `found_by`: the patch per facet before join_borders().
void PatchFinder::merge_patches(const std::vector<Patch>& patches, const std::vector<std::uint32_t>& found_by) {
  std::vector<std::vector<std::uint32_t>> facets(patches.size()), core(patches.size());
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) facets[patch_of_[f]].push_back(f);
    if (found_by[f] != kNone) core[found_by[f]].push_back(f);
  }
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t l, std::uint32_t r) { return facets[l].size() > facets[r].size(); });
  for (const std::uint32_t p : order) {
    forget_looks();
    for (std::size_t i = 0; i < facets[p].size(); ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[p][i])) {
        const std::uint32_t q = patch_of_[arc.facet];
        if (q == kNone || q == p || facets[q].size() > facets[p].size() || patches[q].outward != patches[p].outward)
          continue;
        const auto lies_on_p = [&](std::uint32_t f) { return lies_on(patches[p], f, kMergedSags * patches[p].sag); };
        if (!std::all_of(core[q].begin(), core[q].end(), lies_on_p)) continue;
        for (const std::uint32_t f : facets[q]) patch_of_[f] = p;
        facets[p].insert(facets[p].end(), facets[q].begin(), facets[q].end());
        facets[q].clear();
      }
    }
  }
}

}  // namespace ligne
