#include <algorithm>
#include <limits>
#include <tuple>

#include "base/parallel.hpp"
#include "visibility/common/cell_cover.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet_in_cell.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
constexpr std::size_t kLeafFacets = 24;      ///< a list longer than this is split if large facets may cover children
constexpr std::size_t kMaxListLength = 256;  ///< a list longer than this is split anyway
constexpr double kLargeBreadth = 0.6;        ///< a facet broader than this times the cell's side is large
constexpr double kLargePart = 0.25;          ///< least share of large facets in a list worth splitting
constexpr double kGain = 0.7;                ///< lists must shrink below this ratio; see `progress` in split()

/// Often the list is already sorted: removing entries keeps the order.
void sort_by_depth(CellFacet* begin, CellFacet* end) {
  const auto before = [](const CellFacet& a, const CellFacet& b) {
    return a.z_near != b.z_near ? a.z_near < b.z_near : a.facet < b.facet;
  };
  if (!std::is_sorted(begin, end, before)) std::sort(begin, end, before);
}

}  // namespace

/// Splits cells with long lists, and completes the leaves.
struct CellGrid::Splitter {
  const ProjectedScene& scene;
  const std::vector<Facet>& facets;
  const Options& options;
  CellGrid& grid;

  bool hides(const Facet& f) const { return options.hides(scene, f); }
  /// Where two facets coincide, the one of the lower face is visible.
  bool comes_first(std::uint32_t a, std::uint32_t b) const {
    return facets[a].face != facets[b].face ? facets[a].face < facets[b].face : a < b;
  }
  bool should_split(const CellFacet* list, std::size_t n, double size) const;
  void split_overfull();
  /// To be called once per leaf, when its list is complete.
  void finish_leaf(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
                   std::vector<LeafPlane>& planes) const;
  bool of_one_face(const CellFacet* list, std::size_t n) const;
  /// Removes the facets behind the cell's cover from a long list; returns its new length.
  std::size_t drop_covered(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square, CellCover& cover) const;
  static constexpr int kChildren = kSplitSide * kSplitSide;
  /// Lists and nearest covers of the children of a cell, row by row.
  struct Children {
    std::vector<CellFacet> lists[kChildren];
    float covers[kChildren];
  };
  /// Sorts the inherited entries, nearest first, and distributes them to the children.
  void distribute(const Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, Children& children) const;
  /// The arena into which a task splits cells, and its work space.
  struct Store {
    Arena& arena;
    std::uint8_t index;  ///< number of the arena
    CellCover& cover;
  };
  /// `budget`: largest number of entries that the leaves of the cell should have.
  void split(Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, double budget, Store& store);
};

/// Facets broader than a child cell cover some children and hide what is behind them. Splitting only spreads small
/// facets.
bool CellGrid::Splitter::should_split(const CellFacet* list, std::size_t n, double size) const {
  if (n <= kLeafFacets || size < kSplitSide * kSmallestCell) return false;
  if (n > kMaxListLength) return !of_one_face(list, n);
  if (!options.drop_hidden) return false;
  std::size_t large = 0;
  for (std::size_t i = 0; i < n; ++i) large += breadth(facets[list[i].facet], scene.vertices.data()) > kLargeBreadth * size;
  return static_cast<double>(large) > kLargePart * static_cast<double>(n);
}

void CellGrid::Splitter::split_overfull() {
  // The number of arenas is fixed, so that the structure does not depend on the number of threads.
  constexpr std::size_t kArenas = 64;
  static_assert(kArenas <= std::numeric_limits<decltype(Cell::arena)>::max());
  grid.arenas_.resize(kArenas + 1);
  const std::size_t n = grid.cells_.size();
  parallel_for(kArenas, [&](std::size_t k) {
    CellCover cover(scene, facets, options.margin_steps);
    for (std::size_t i = n * k / kArenas; i < n * (k + 1) / kArenas; ++i) {
      Cell& cell = grid.cells_[i];
      CellFacet* list = grid.arenas_[0].list.data() + cell.begin;
      cell.count = static_cast<std::uint32_t>(drop_covered(cell, list, cell.count, grid.top_square(i), cover));
    }
  });
  double entries = 0;
  for (const Cell& cell : grid.cells_) entries += cell.count;
  const double budget = most_entries(facets.size()) / entries;
  parallel_for(kArenas, [&](std::size_t k) {
    Arena& arena = grid.arenas_[k + 1];
    std::vector<CellFacet> inherited;
    CellCover cover(scene, facets, options.margin_steps);
    Store store{arena, static_cast<std::uint8_t>(k + 1), cover};
    for (std::size_t i = n * k / kArenas; i < n * (k + 1) / kArenas; ++i) {
      Cell& cell = grid.cells_[i];
      CellFacet* list = grid.arenas_[0].list.data() + cell.begin;
      if (!should_split(list, cell.count, grid.size_)) {
        finish_leaf(cell, list, cell.count, grid.top_square(i), arena.planes);
        continue;
      }
      inherited.assign(list, list + cell.count);
      split(cell, grid.top_square(i), inherited, budget * static_cast<double>(inherited.size()), store);
    }
  });
  for (Arena& arena : grid.arenas_) grid.planes_.insert(grid.planes_.end(), arena.planes.begin(), arena.planes.end());
  std::sort(grid.planes_.begin(), grid.planes_.end(),
            [](const LeafPlane& a, const LeafPlane& b) { return std::tie(a.arena, a.begin) < std::tie(b.arena, b.begin); });
}

bool CellGrid::Splitter::of_one_face(const CellFacet* list, std::size_t n) const {
  return std::all_of(list, list + n, [&](const CellFacet& c) { return facets[c.facet].face == facets[list->facet].face; });
}

std::size_t CellGrid::Splitter::drop_covered(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
                                             CellCover& cover) const {
  if (n <= kLeafFacets || !options.drop_hidden) return n;
  sort_by_depth(list, list + n);
  const auto depth = cover.find(list, n, square, [&](const Facet& f) { return hides(f); });
  if (!depth) return n;
  cell.occluder_depth = std::min(cell.occluder_depth, *depth);
  const auto is_hidden = [&](const CellFacet& c) {
    if (c.z_near > cell.occluder_depth) return true;
    const bool by_planes = cover.hides(facets[c.facet]);
    cell.dropped_by_planes |= by_planes;
    return by_planes;
  };
  return static_cast<std::size_t>(std::remove_if(list, list + n, is_hidden) - list);
}

void CellGrid::Splitter::finish_leaf(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
                                     std::vector<LeafPlane>& planes) const {
  cell.one_face = of_one_face(list, n);
  sort_by_depth(list, list + n);
  const double margin = options.margin_steps;
  for (std::size_t i = 0; i < n; ++i) {
    const PageBox b = page_box(facets[list[i].facet], scene.vertices.data());
    list[i].box = square.box(b.left - margin, b.right + margin, b.top - margin, b.bottom + margin);
  }
  if (n <= CommonPlane::kLongList || cell.one_face) return;
  if (const auto plane = CommonPlane::of(scene, facets, {list, n})) {
    cell.one_plane = true;
    planes.push_back({cell.arena, cell.begin, *plane});
  }
}

void CellGrid::Splitter::distribute(const Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited,
                                    Children& children) const {
  const double size = square.size / kSplitSide;
  std::vector<CellFacet>* lists = children.lists;
  float* covers = children.covers;
  std::fill_n(covers, kChildren, cell.occluder_depth);
  NearestCover nearest[kChildren];
  // Nearest first: covers are found before what they hide.
  sort_by_depth(inherited.data(), inherited.data() + inherited.size());
  for (const CellFacet& entry : inherited) {
    const Facet& f = facets[entry.facet];
    const PageBox box = page_box(f, scene.vertices.data());
    const auto child_at = [&](double v) { return v < 0 ? 0 : v >= kSplitSide ? kSplitSide - 1 : static_cast<int>(v); };
    const int left = child_at((box.left - options.margin_steps - square.x) / size);
    const int right = child_at((box.right + options.margin_steps - square.x) / size);
    const int top = child_at((box.top - options.margin_steps - square.y) / size);
    const int bottom = child_at((box.bottom + options.margin_steps - square.y) / size);
    const FacetFunctions g(f, scene.vertices.data());
    for (int k = top * kSplitSide + left; k <= bottom * kSplitSide + right; ++k) {
      if (k % kSplitSide < left || k % kSplitSide > right) continue;
      if (options.drop_hidden && entry.z_near > covers[k]) continue;
      const CellSquare child = child_square(square, k);
      double z_near = 0, z_far = 0;
      const Meeting m = meet(g, f, child, options.margin_steps, z_near, z_far);
      if (m == Meeting::apart || (options.drop_hidden && z_near > covers[k])) continue;
      const CellFacet listed{entry.facet, round_down(z_near), {}};
      if (m != Meeting::covers || !hides(f)) {
        lists[k].push_back(listed);
        continue;
      }
      covers[k] = std::min(covers[k], round_up(z_far + f.depth_tolerance));
      if (!nearest[k].stands_for(g, child)) {
        nearest[k] = {g, lists[k].size(), true};
        lists[k].push_back(listed);
      } else if (CellFacet& other = lists[k][nearest[k].entry]; comes_first(entry.facet, other.facet)) {
        nearest[k].functions = g;
        other = listed;
      }
    }
  }
}

void CellGrid::Splitter::split(Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, double budget,
                               Store& store) {
  Arena& arena = store.arena;
  Children children;
  distribute(cell, square, inherited, children);
  std::vector<CellFacet>* lists = children.lists;
  float* covers = children.covers;
  const double size = square.size / kSplitSide;
  std::size_t total = 0;
  for (int k = 0; k < kChildren; ++k) {
    if (options.drop_hidden) std::erase_if(lists[k], [&](const CellFacet& c) { return c.z_near > covers[k]; });
    total += lists[k].size();
  }
  // A line through the cell meets kSplitSide children. A child is split again if the children of this cell save work
  // for such a line, or if its list is clearly shorter than its parent's: no split helps where many sides lie along one
  // line. The estimate assumes that the lists of a child grow by this cell's ratio.
  const double growth = static_cast<double>(total) / static_cast<double>(inherited.size());
  const double parent = kGain * static_cast<double>(inherited.size());
  const bool all_gain = static_cast<double>(total) < parent * kSplitSide;
  const auto progress = [&](const std::vector<CellFacet>& list) {
    const auto n_child = static_cast<double>(list.size());
    if (n_child * growth > budget * (n_child / static_cast<double>(total))) return false;
    return all_gain || n_child < parent;
  };
  const auto first = static_cast<std::uint32_t>(arena.children.size());
  arena.children.resize(first + kChildren);
  inherited.clear();
  cell.begin = first;
  cell.count = Cell::kSplit;
  cell.arena = store.index;
  for (int k = 0; k < kChildren; ++k) {
    Cell child{.occluder_depth = covers[k], .arena = store.index, .dropped_by_planes = cell.dropped_by_planes};
    const CellSquare below = child_square(square, k);
    lists[k].resize(drop_covered(child, lists[k].data(), lists[k].size(), below, store.cover));
    if (should_split(lists[k].data(), lists[k].size(), size) && progress(lists[k])) {
      split(child, below, lists[k], budget * static_cast<double>(lists[k].size()) / static_cast<double>(total), store);
    } else {
      child.begin = static_cast<std::uint32_t>(arena.list.size());
      child.count = static_cast<std::uint32_t>(lists[k].size());
      finish_leaf(child, lists[k].data(), lists[k].size(), below, arena.planes);
      arena.list.insert(arena.list.end(), lists[k].begin(), lists[k].end());
    }
    arena.children[first + k] = child;
    std::vector<CellFacet>().swap(lists[k]);
  }
}

void CellGrid::split_overfull(const ProjectedScene& scene, const std::vector<Facet>& facets, const Options& options) {
  Splitter{scene, facets, options, *this}.split_overfull();
}

}  // namespace ligne
