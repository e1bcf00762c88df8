#include "picture/choice/face_pairs.hpp"

#include <algorithm>

#include "view/tolerances.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {
namespace {

/// Adjustable: largest number of pairs of facets that are tested, at about 0.1 microseconds each.
constexpr std::uint64_t kMaxTests = 4'000'000;

std::uint64_t pair_of(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

void keep_each_once(std::vector<std::uint64_t>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Tests the pairs of each leaf of the grid, until kMaxTests tests are done.
class PairSearch {
 public:
  PairSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid)
      : facets_(facets), grid_(grid), penetrations_(facets, scene.vertices) {}

  void look(const Cell& cell) {
    if (cell.count < 2 || cell.one_face) return;
    const CellFacet* list = grid_.list(cell);
    placed_.clear();
    for (std::uint32_t i = 0; i < cell.count; ++i) placed_.push_back(penetrations_.place(list[i].facet));
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      for (std::uint32_t k = i + 1; k < cell.count; ++k) {
        if (tests_ == kMaxTests) return;
        ++tests_;
        if (placed_[i].face == placed_[k].face || !list[i].box.meets(list[k].box)) continue;
        // The list is sorted by the nearest depth. If the second facet is wholly behind the first one, they can only
        // overlap.
        const bool may_penetrate = list[k].z_near <= facets_[list[i].facet].z_far;
        if (may_penetrate) penetrations_.test(placed_[i], placed_[k], [](const PageSegment&) { return true; });
        if (overlap_on_page(placed_[i], placed_[k])) found_.overlapping.push_back(pair_of(placed_[i].face, placed_[k].face));
      }
    }
    penetrations_.forget_repeated();
  }

  FacePairs finish(double least_steps) {
    keep_each_once(found_.overlapping);
    for (const Intersection& x : penetrations_.finish(least_steps)) {
      if (x.face0 != x.face1) found_.penetrating.push_back(pair_of(x.face0, x.face1));
    }
    keep_each_once(found_.penetrating);
    found_.complete = tests_ < kMaxTests;
    return std::move(found_);
  }

 private:
  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  PenetrationSearch penetrations_;
  std::vector<PlacedFacet> placed_;
  std::uint64_t tests_ = 0;
  FacePairs found_;
};

}  // namespace

CellGrid grid_of_all(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps) {
  CellGrid::Options options;
  options.margin_steps = coincidence_steps + 1;
  options.drop_hidden = false;
  return {scene, facets, options};
}

FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid) {
  PairSearch search(scene, facets, grid);
  for (std::size_t i = 0; i < grid.top_cell_count(); ++i) {
    grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare&) { search.look(cell); });
  }
  return search.finish(kLeastPartMm / scene.lattice.step_mm);
}

}  // namespace ligne
