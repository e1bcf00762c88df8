#include "visibility/common/intersections.hpp"

#include <algorithm>
#include <array>

#include "geometry/parallel.hpp"
#include "view/tolerances.hpp"

// Per leaf all pairs of facets that may meet in depth and on the page are tested.

namespace ligne {
namespace {

bool seen_in(const PageSegment& s, const CellSquare& square, double margin, float cover) {
  const double x0 = square.x - margin, x1 = square.x + square.size + margin;
  const double y0 = square.y - margin, y1 = square.y + square.size + margin;
  const auto part = clip_parameters<4>({s.from.x - x0, x1 - s.from.x, s.from.y - y0, y1 - s.from.y},
                                       {s.to.x - x0, x1 - s.to.x, s.to.y - y0, y1 - s.to.y});
  if (!part) return false;
  return !(s.at((*part)[0]).z > cover && s.at((*part)[1]).z > cover);
}

/// What one task works with.
class LeafSearch {
 public:
  LeafSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, double margin)
      : found(facets, scene.vertices), facets_(facets), grid_(grid), margin_(margin) {}

  void search(const Cell& cell, const CellSquare& square) {
    if (cell.count < 2) return;
    items_.clear();
    const CellFacet* list = grid_.list(cell);
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      items_.push_back({found.place(list[i].facet), list[i].z_near, facets_[list[i].facet].z_far, list[i].box});
    }
    const auto wanted = [&](const PageSegment& s) {
      return grid_.complete() || seen_in(s, square, margin_, cell.occluder_depth);
    };
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& a = items_[i];
      for (std::size_t k = i + 1; k < items_.size(); ++k) {
        const Item& b = items_[k];
        if (b.z_near > a.z_far) break;  // items are ordered by z_near
        if (a.box.meets(b.box) && a.place.face != b.place.face) found.test(a.place, b.place, wanted);
      }
    }
  }

  PenetrationSearch found;

 private:
  struct Item {
    PlacedFacet place;
    float z_near, z_far;
    CellBox box;
  };

  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  double margin_;
  std::vector<Item> items_;
};

}  // namespace

std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps) {
  constexpr std::size_t kCellsPerTask = 256;
  const std::size_t n = grid.top_cell_count(), tasks = (n + kCellsPerTask - 1) / kCellsPerTask;
  std::vector<PenetrationSearch> found(tasks, PenetrationSearch(facets, scene.vertices));
  parallel_for(tasks, [&](std::size_t task) {
    LeafSearch search(scene, facets, grid, margin_steps);
    for (std::size_t i = task * kCellsPerTask; i < std::min(n, (task + 1) * kCellsPerTask); ++i) {
      grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare& square) { search.search(cell, square); });
    }
    found[task] = std::move(search.found);
  });
  PenetrationSearch all(facets, scene.vertices);
  for (PenetrationSearch& f : found) all.add(std::move(f));
  return all.finish(kLeastPartMm / scene.lattice.step_mm);
}

}  // namespace ligne
