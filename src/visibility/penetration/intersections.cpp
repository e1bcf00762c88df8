#include "visibility/penetration/intersections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/occluder_cache.hpp"
#include "visibility/penetration/facet_tree.hpp"
#include "visibility/penetration/joined_facets.hpp"
#include "visibility/penetration/parallel_extents.hpp"

// Tests, leaf by leaf, all pairs of facets that may meet in depth and on the page; if hidden segments are wanted too,
// all such pairs of the scene.

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

// Adjustable: number of facets in a leaf above which pairs are first compared by their planes and boxes, and above which
// facets are first sorted out that need no comparison at all.
constexpr std::uint32_t kFullLeaf = 32, kManyTogether = 128;
// Adjustable: number of facets in a leaf above which tasks share its pairs, and facets per task.
constexpr std::size_t kManyItems = 1024, kItemsPerTask = 256;

/// Least number of facets in a leaf for the test whether they lie in one plane. Adjustable.
constexpr std::size_t kSeveral = 4;

double least_steps(const ProjectedScene& scene) { return kLeastPartMm / scene.lattice.step_mm; }

/// Work space and results of one task's comparisons.
struct Comparisons {
  Comparisons(const ProjectedScene& scene, const std::vector<Facet>& facets, const PenetrationSearch& all)
      : found(all.empty_copy()), hiders(scene, facets, least_steps(scene)) {}
  PenetrationSearch found;
  OccluderCache hiders;
};

/// Searches leaves one after the other, for one task.
class LeafSearch {
 public:
  LeafSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const std::uint8_t> joined,
             const CellGrid& grid, double margin, const PenetrationSearch& all)
      : scene_(scene), facets_(facets), joined_(joined), grid_(grid), margin_(margin), own_(scene, facets, all) {}

  void search(const Cell& cell, const CellSquare& square) {
    if (cell.count < 2 || cell.one_face || has_layers_apart(cell, square) || in_one_plane(cell)) return;
    items_.clear();
    planes_.clear();
    const Leaf leaf{cell, square, grid_.list(cell), square.size / 2 + margin_};
    const bool is_full = cell.count > kFullLeaf;
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      const CellFacet& listed = leaf.list[i];
      const Facet& facet = facets_[listed.facet];
      items_.push_back({own_.found.place(listed.facet), listed.z_near, facet.z_far, listed.box});
      if (is_full) planes_.emplace_back(FacetFunctions(facet, scene_.vertices.data()), items_.back().place, leaf);
    }
    if (is_full) {
      search_full_leaf(leaf);
    } else {
      search_pairs(leaf);
    }
    own_.found.forget_repeated();
  }

  PenetrationSearch take() { return std::move(own_.found); }

 private:
  struct Item {
    PlacedFacet place;
    float z_near, z_far;
    CellBox box;
  };

  struct Leaf {
    const Cell& cell;
    const CellSquare& square;
    const CellFacet* list;
    double reach;  ///< half the side of the leaf, plus the margin
  };

  /// A facet's plane over the cell: its depth at the centre, its slopes, and the facet's box about the centre, as far as it
  /// lies within reach.
  struct Plane {
    Plane(const FacetFunctions& f, const PlacedFacet& facet, const Leaf& leaf) : zx(f.zx), zy(f.zy), tolerance(f.slack) {
      const double half = leaf.square.size / 2, x = leaf.square.x + half, y = leaf.square.y + half, reach = leaf.reach;
      z = f.depth(x, y);
      const auto [x0, x1] = std::minmax({facet.x[0], facet.x[1], facet.x[2]});
      const auto [y0, y1] = std::minmax({facet.y[0], facet.y[1], facet.y[2]});
      left = std::max(x0 - x, -reach), right = std::min(x1 - x, reach);
      top = std::max(y0 - y, -reach), bottom = std::min(y1 - y, reach);
    }
    double z, zx, zy, tolerance;
    double left, right, top, bottom;
    std::uint32_t group = 0;  ///< planes of one group coincide over the cell: they touch

    /// Whether the planes neither cross nor touch where the boxes meet.
    bool apart(const Plane& o) const {
      const double x0 = std::max(left, o.left), x1 = std::min(right, o.right);
      const double y0 = std::max(top, o.top), y1 = std::min(bottom, o.bottom);
      if (x0 > x1 || y0 > y1) return true;
      const double dx = zx - o.zx, dy = zy - o.zy;
      const double twice = 2 * (z - o.z) + dx * (x0 + x1) + dy * (y0 + y1);
      return std::abs(twice) > std::abs(dx) * (x1 - x0) + std::abs(dy) * (y1 - y0) + 4 * (tolerance + o.tolerance);
    }
  };

  bool has_layers_apart(const Cell& cell, const CellSquare& square) const {
    return !joined_.empty() &&
           ligne::has_layers_apart(scene_, facets_, joined_, {cell, {grid_.list(cell), cell.count}, square, margin_});
  }

  bool in_one_plane(const Cell& cell) const {
    if (cell.one_plane || cell.count < kSeveral || cell.count > CommonPlane::kLongList) return cell.one_plane;
    return CommonPlane::of(scene_, facets_, {grid_.list(cell), cell.count}).has_value();
  }

  bool wanted(const PageSegment& s, const Leaf& leaf) const {
    return seen_in(s, leaf.square, margin_, leaf.cell.occluder_depth);
  }

  void search_pairs(const Leaf& leaf) {
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& a = items_[i];
      for (std::size_t k = i + 1; k < items_.size(); ++k) {
        const Item& b = items_[k];
        if (b.z_near > a.z_far) break;  // items are ordered by z_near
        if (!b.box.meets(a.box) || a.place.face == b.place.face) continue;
        own_.found.test(a.place, b.place, [&](const PageSegment& s) { return wanted(s, leaf); });
      }
    }
  }

  /// Compares the pairs of a full leaf. With many facets, pairs in one plane, pairs of one pencil, and parallel facets side
  /// by side are skipped.
  void search_full_leaf(const Leaf& leaf) {
    const std::size_t n = items_.size();
    if (n > kManyTogether) {
      group_planes(leaf.reach);
      find_pencil();
    }
    are_parallel_ = n > kManyTogether && set_extents(leaf.square);
    if (n <= kManyItems) return compare(leaf, 0, n, own_);
    const std::size_t blocks = block_count(n, kItemsPerTask);
    std::vector<std::optional<Comparisons>> made(blocks);
    parallel_for(blocks, [&](std::size_t block) {
      Comparisons& own = made[block].emplace(scene_, facets_, own_.found);
      compare(leaf, block * kItemsPerTask, std::min(n, (block + 1) * kItemsPerTask), own);
    });
    for (std::optional<Comparisons>& part : made) own_.found.add(std::move(part->found));
  }

  /// Compares the items [begin, end) of a full leaf with the items after them in the list.
  void compare(const Leaf& leaf, std::size_t begin, std::size_t end, Comparisons& own) const {
    const auto n = static_cast<std::uint32_t>(items_.size());
    const bool many = n > kManyTogether;
    std::vector<std::uint32_t> space;
    // The farthest items come first: most of their segments are hidden, so `hiders` learns the facets that hide.
    for (auto i = static_cast<std::uint32_t>(end); i-- > begin;) {
      const auto compare_with = [&](std::uint32_t k) { return compare_in_full_leaf(i, k, many, leaf, own); };
      if (many && in_pencil_[i]) {
        auto other = std::upper_bound(outside_.begin(), outside_.end(), i);
        while (other != outside_.end() && compare_with(*other)) ++other;
      } else if (are_parallel_) {
        for (const std::uint32_t k : extents_.overlapping(i, i + 1, first_behind(i), space)) compare_with(k);
      } else {
        std::uint32_t k = i + 1;
        while (k < n && compare_with(k)) ++k;
      }
      own.found.forget_repeated();
    }
  }

  /// Returns whether items after k are to be compared with item i, too.
  bool compare_in_full_leaf(std::uint32_t i, std::uint32_t k, bool many, const Leaf& leaf, Comparisons& own) const {
    const Item &a = items_[i], &b = items_[k];
    if (b.z_near > a.z_far) return false;
    if (!b.box.meets(a.box) || a.place.face == b.place.face) return true;
    if (planes_[i].apart(planes_[k]) || (many && planes_[i].group == planes_[k].group)) return true;
    const auto pair_wanted = [&](const PageSegment& s) {
      if (!wanted(s, leaf)) return false;
      const PageLine line(rounded(s.from), rounded(s.to), a.place.face, b.place.face);
      return !own.hiders.hide(line, {leaf.list, leaf.cell.count}, leaf.square);
    };
    own.found.test(a.place, b.place, pair_wanted);
    return true;
  }

  /// Finds the pencil: the largest set of facets with a common side. Their planes meet in the line of that side, which
  /// is not a penetration if it is also a side of their faces; so no two of them need a comparison. (If the side is only a
  /// cut of a face's triangulation, another facet of the face has the same side, in this leaf or in another leaf along
  /// the side.)
  void find_pencil() {
    side_uses_.clear();
    for (std::uint32_t i = 0; i < items_.size(); ++i) {
      const PlacedFacet& f = items_[i].place;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = scene_.place(f.v[k]), w = scene_.place(f.v[(k + 1) % 3]);
        side_uses_.push_back({std::uint64_t{std::min(v, w)} << 32 | std::max(v, w), f.face, i});
      }
    }
    std::sort(side_uses_.begin(), side_uses_.end());
    std::size_t largest = 0, largest_end = 0;
    for (std::size_t begin = 0, end = 0; begin < side_uses_.size(); begin = end) {
      bool is_cut = false;
      for (end = begin + 1; end < side_uses_.size() && side_uses_[end].side == side_uses_[begin].side; ++end)
        is_cut = is_cut || side_uses_[end].face == side_uses_[end - 1].face;
      if (!is_cut && end - begin > largest_end - largest) largest = begin, largest_end = end;
    }
    in_pencil_.assign(items_.size(), false);
    for (std::size_t i = largest; i < largest_end; ++i) in_pencil_[side_uses_[i].item] = true;
    outside_.clear();
    for (std::uint32_t i = 0; i < items_.size(); ++i) {
      if (!in_pencil_[i]) outside_.push_back(i);
    }
  }

  bool set_extents(const CellSquare& square) {
    std::vector<const PlacedFacet*> places;
    for (const Item& item : items_) places.push_back(&item.place);
    return extents_.set(places, square, margin_);
  }

  /// The first item that lies behind an item as a whole.
  std::uint32_t first_behind(std::uint32_t i) const {
    const auto behind = std::ranges::upper_bound(items_.begin() + i + 1, items_.end(), items_[i].z_far, {}, &Item::z_near);
    return static_cast<std::uint32_t>(behind - items_.begin());
  }

  /// Groups planes whose depths over the cell are equal, in units of the tolerance. Faces in one plane are then not
  /// compared, even if there are a thousand.
  void group_planes(double reach) {
    keys_.clear();
    for (std::uint32_t i = 0; i < planes_.size(); ++i) {
      const Plane& p = planes_[i];
      // Planes that coincide have one gradient, and so about one tolerance.
      int exponent = 0;
      std::frexp(p.tolerance, &exponent);
      const double unit = std::ldexp(1.0, exponent), per_unit = std::ldexp(1.0, -exponent);
      const auto rounded = [&](double z) { return std::floor(z * per_unit + 0.5); };
      keys_.push_back({{unit, rounded(p.z), rounded(p.zx * reach), rounded(p.zy * reach)}, i});
    }
    std::sort(keys_.begin(), keys_.end());
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const bool same = i > 0 && keys_[i].first == keys_[i - 1].first;
      planes_[keys_[i].second].group = same ? planes_[keys_[i - 1].second].group : keys_[i].second;
    }
  }

  /// A side of an item's facet, by its places.
  struct SideUse {
    std::uint64_t side;
    std::uint32_t face, item;
    bool operator<(const SideUse& o) const { return std::tie(side, face, item) < std::tie(o.side, o.face, o.item); }
  };

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  std::span<const std::uint8_t> joined_;
  const CellGrid& grid_;
  double margin_;
  Comparisons own_;
  std::vector<Item> items_;
  std::vector<Plane> planes_;  ///< planes of the items, in full leaves
  std::vector<std::pair<std::array<double, 4>, std::uint32_t>> keys_;
  std::vector<SideUse> side_uses_;
  std::vector<bool> in_pencil_;         ///< per item: whether it belongs to the pencil
  std::vector<std::uint32_t> outside_;  ///< the items outside the pencil
  ParallelExtents extents_;             ///< those of the items, if they are parallel
  bool are_parallel_ = false;
};

/// Whether it is stated that no faces penetrate each other.
bool nothing_penetrates(const ProjectedScene& scene) {
  return scene.model && scene.model->stated.has(StatedFact::no_penetration);
}

}  // namespace

std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps,
                                             std::span<const std::uint8_t> joined) {
  if (nothing_penetrates(scene)) return {};
  if (grid.complete()) return find_crossing_facets(scene, facets).finish(least_steps(scene));
  // Crowded cells lie beside each other, so that few tasks would be uneven.
  constexpr std::size_t kFewTasks = 24, kLeastCells = 16, kMostCells = 256;
  const std::size_t n = grid.top_cell_count(), cells = std::clamp(n / kFewTasks, kLeastCells, kMostCells);
  const std::size_t tasks = (n + cells - 1) / cells;
  PenetrationSearch all(facets, scene.vertices);
  std::vector<PenetrationSearch> found(tasks, all.empty_copy());
  parallel_for(tasks, [&](std::size_t task) {
    LeafSearch search(scene, facets, joined, grid, margin_steps, all);
    for (std::size_t i = task * cells; i < std::min(n, (task + 1) * cells); ++i) {
      grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare& square) { search.search(cell, square); });
    }
    found[task] = search.take();
  });
  for (PenetrationSearch& f : found) all.add(std::move(f));
  return all.finish(least_steps(scene));
}

std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             double coincidence_steps, bool hidden_too) {
  if (nothing_penetrates(scene)) return {};
  if (hidden_too) return find_crossing_facets(scene, facets).finish(least_steps(scene));
  CellGrid::Options options{.margin_steps = coincidence_steps + 1, .drop_hidden = true};
  return find_intersections(scene, facets, CellGrid(scene, facets, options), options.margin_steps);
}

}  // namespace ligne
