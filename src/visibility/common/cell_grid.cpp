#include "visibility/common/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/indices_where.hpp"
#include "geometry/large_vector.hpp"
#include "geometry/parallel.hpp"
#include "visibility/common/cell_cover.hpp"
#include "visibility/common/facet_in_cell.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
constexpr std::size_t kLeafFacets = 24;      ///< a list longer than this is split if large facets may cover children
constexpr std::size_t kCrowdedFacets = 256;  ///< a list longer than this is split anyway
constexpr double kLargeBreadth = 0.6;        ///< facets broader than so many sides of the cell are large
constexpr double kLargePart = 0.25;          ///< what part of the list must be large facets
constexpr double kSizeFactor = 1.5;          ///< side of a top-level cell over the mean extent of a facet
constexpr double kCellsPerFacet = 1.0;       ///< at most so many top-level cells
constexpr double kMinCells = 256;
constexpr double kEntriesPerFacet = 64;  ///< the leaves have about so many entries at the most for each facet,
constexpr double kLeastBudget = 2.5e5;   ///< or so many in all, whichever is more
constexpr double kSmallestCell = 64;     ///< steps; smaller cells are not split
constexpr double kGain = 0.7;            ///< see progress in split()
constexpr std::size_t kFacetsPerBlock = 65'536;

/// A list that was in this order may have lost some of its entries since.
void sort_by_depth(CellFacet* begin, CellFacet* end) {
  const auto before = [](const CellFacet& a, const CellFacet& b) {
    return a.z_near != b.z_near ? a.z_near < b.z_near : a.facet < b.facet;
  };
  if (!std::is_sorted(begin, end, before)) std::sort(begin, end, before);
}

}  // namespace

struct CellGrid::Build {
  struct Range {
    std::uint16_t column0, column1, row0, row1;
  };

  const ProjectedScene& scene;
  const std::vector<Facet>& facets;
  const Options& options;
  CellGrid& grid;
  std::vector<std::uint8_t> wanted;   ///< per top-level cell, when only some are filled
  std::vector<std::uint32_t> listed;  ///< then the facets in whose range one of these is
  std::vector<Range> ranges;          ///< of all facets or of those listed, margin included

  bool hides(const Facet& f) const {
    return !options.see_through || scene.face_is_transparent.empty() || !scene.face_is_transparent[f.face];
  }
  /// Of two facets that coincide the one of the lower face is seen.
  bool comes_first(std::uint32_t a, std::uint32_t b) const {
    return facets[a].face != facets[b].face ? facets[a].face < facets[b].face : a < b;
  }
  bool choose_cells();
  void mark_wanted();
  Range range_of(const Facet& f) const;
  bool is_wanted(const Range& r) const;
  void find_ranges();
  /// Facets that are filed, and the number of the k-th.
  std::size_t filed() const { return wanted.empty() ? facets.size() : listed.size(); }
  std::size_t facet_number(std::size_t k) const { return wanted.empty() ? k : listed[k]; }
  void find_occluders();
  void fill();
  bool worth_splitting(const CellFacet* list, std::size_t n, double size) const;
  void split_overfull();
  /// To be called once per leaf, when its list is complete.
  void finish_leaf(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
                   std::vector<LeafPlane>& planes) const;
  bool of_one_face(const CellFacet* list, std::size_t n) const;
  /// Removes from a long list what lies behind the cell's cover; gives the list's new length.
  std::size_t drop_covered(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square, CellCover& cover) const;
  static constexpr int kChildren = kSplitSide * kSplitSide;
  /// Lists and nearest covers of the children of a cell, row by row.
  struct Children {
    std::vector<CellFacet> lists[kChildren];
    float covers[kChildren];
  };
  /// Files what the cell inherited under its children. Sorts it, nearest first.
  void hand_down(const Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, Children& children) const;
  /// `budget`: how many entries the leaves of the cell should have at the most.
  void split(Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, Arena& arena,
             std::uint16_t arena_index, double budget, CellCover& cover);

  /// Rows are dealt out in bands, each filled by one task that scans all facets: lists keep the order of the facets.
  template <class Work>
  void for_each_band(Work work) const {
    const int bands = std::clamp(static_cast<int>(facets.size() / kFacetsPerBlock), 1, 4);
    parallel_for(static_cast<std::size_t>(bands), [&](std::size_t band) {
      const int b = static_cast<int>(band);
      work(grid.rows_ * b / bands, grid.rows_ * (b + 1) / bands);
    });
  }
  /// Calls visit(facet, cell, meeting, z_near, z_far) for all cells in rows [row0, row1) that facets meet.
  template <class Visit>
  void for_each_meeting(int row0, int row1, bool large_only, Visit visit) const;
};

bool CellGrid::Build::choose_cells() {
  /// Of all facets: sums of width and height, area and length of the outline, and the box round them.
  struct Extent {
    double sides = 0, area = 0, outline = 0;
    double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;
  };
  const auto extent_of = [&](std::size_t begin, std::size_t end) {
    Extent e;
    for (std::size_t i = begin; i < end; ++i) {
      const Facet& f = facets[i];
      const PageBox box = page_box(f, scene.vertices.data());
      e.sides += (box.right - box.left) + (box.bottom - box.top);
      e.area += orientation(scene.vertices[f.v[0]].p, scene.vertices[f.v[1]].p, scene.vertices[f.v[2]].p) / 2;
      e.outline += 2 * f.size;
      e.x0 = std::min(e.x0, box.left);
      e.x1 = std::max(e.x1, box.right);
      e.y0 = std::min(e.y0, box.top);
      e.y1 = std::max(e.y1, box.bottom);
    }
    return e;
  };
  const auto together = [](const Extent& a, const Extent& b) {
    return Extent{a.sides + b.sides,    a.area + b.area,      a.outline + b.outline, std::min(a.x0, b.x0),
                  std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
  };
  const auto [sides, area, outline, x0, y0, x1, y1] =
      parallel_reduce(facets.size(), kFacetsPerBlock, Extent{}, extent_of, together);
  if (facets.empty()) return false;
  const double n = static_cast<double>(facets.size());
  const double width = x1 - x0 + 1, height = y1 - y0 + 1;
  double size = kSizeFactor * sides / (2 * n);
  size = std::max(size, std::sqrt(width * height / std::max(kMinCells, kCellsPerFacet * n)));
  size = std::max(size, std::max(width, height) / 4096);
  size = std::min(size, std::sqrt(width * height / kMinCells));
  size = std::max({size, kSmallestCell, std::max(width, height) / 4096});
  // Large facets lie in many cells: about area / size^2 + outline / size of them, which must be no more than the limit.
  const double limit = std::max(kEntriesPerFacet * n, kLeastBudget) / 2;
  size = std::max(size, (outline + std::sqrt(outline * outline + 4 * limit * area)) / (2 * limit));
  // A whole number of steps, so that cell borders are exact.
  grid.size_ = std::ceil(size);
  grid.x_ = x0;
  grid.y_ = y0;
  grid.columns_ = static_cast<int>(width / grid.size_) + 1;
  grid.rows_ = static_cast<int>(height / grid.size_) + 1;
  return true;
}

void CellGrid::Build::mark_wanted() {
  if (!options.only_along) return;
  wanted.assign(grid.cells_.size(), 0);
  for (const ProjectedEdge& edge : *options.only_along) {
    const PageLine line(scene.vertices[edge.v0], scene.vertices[edge.v1], kNone, kNone);
    grid.for_each_leaf(line, [&](const Cell& cell, const CellSquare&, double, double) {
      wanted[static_cast<std::size_t>(&cell - grid.cells_.data())] = 1;
    });
  }
}

CellGrid::Build::Range CellGrid::Build::range_of(const Facet& f) const {
  const double inverse = 1 / grid.size_, margin = options.margin_steps;
  const auto clamped = [](double v, int n) { return static_cast<std::uint16_t>(v < 0 ? 0 : v >= n ? n - 1 : v); };
  const auto [left, right, top, bottom] = page_box(f, scene.vertices.data());
  return {clamped((left - margin - grid.x_) * inverse, grid.columns_),
          clamped((right + margin - grid.x_) * inverse, grid.columns_),
          clamped((top - margin - grid.y_) * inverse, grid.rows_),
          clamped((bottom + margin - grid.y_) * inverse, grid.rows_)};
}

bool CellGrid::Build::is_wanted(const Range& r) const {
  for (int row = r.row0; row <= r.row1; ++row) {
    const auto first = wanted.begin() + static_cast<std::ptrdiff_t>(row) * grid.columns_;
    const auto last = first + r.column1 + 1;
    if (std::find(first + r.column0, last, 1) != last) return true;
  }
  return false;
}

void CellGrid::Build::find_ranges() {
  if (!wanted.empty()) {
    listed = indices_where(facets.size(), [&](std::size_t i) { return is_wanted(range_of(facets[i])); });
  }
  ranges = large_vector<Range>(filed());
  parallel_blocks(filed(), kFacetsPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) ranges[k] = range_of(facets[facet_number(k)]);
  });
}

template <class Visit>
void CellGrid::Build::for_each_meeting(int row0, int row1, bool large_only, Visit visit) const {
  for (std::size_t k = 0; k < filed(); ++k) {
    const std::size_t i = facet_number(k);
    const Range r = ranges[k];
    if (r.row1 < row0 || r.row0 >= row1) continue;
    const int columns = r.column1 - r.column0 + 1, rows = r.row1 - r.row0 + 1;
    if (large_only && (columns < 3 || rows < 3)) continue;
    const Facet& f = facets[i];
    const int first = std::max<int>(r.row0, row0), last = std::min<int>(r.row1, row1 - 1);
    if (columns == 1 || rows == 1 || columns * rows <= 4) {
      for (int row = first; row <= last; ++row) {
        for (int column = r.column0; column <= r.column1; ++column) {
          const std::size_t cell = static_cast<std::size_t>(row) * grid.columns_ + column;
          if (!wanted.empty() && !wanted[cell]) continue;
          visit(i, cell, Meeting::meets, f.z_near, f.z_far);
        }
      }
      continue;
    }
    const FacetFunctions g(f, scene.vertices.data());
    for (int row = first; row <= last; ++row) {
      for (int column = r.column0; column <= r.column1; ++column) {
        const std::size_t cell = static_cast<std::size_t>(row) * grid.columns_ + column;
        if (!wanted.empty() && !wanted[cell]) continue;
        double z_near = 0, z_far = 0;
        const Meeting m = meet(g, f, grid.top_square(cell), options.margin_steps, z_near, z_far);
        if (m != Meeting::apart) visit(i, cell, m, z_near, z_far);
      }
    }
  }
}

void CellGrid::Build::find_occluders() {
  for_each_band([&](int row0, int row1) {
    for_each_meeting(row0, row1, true, [&](std::size_t i, std::size_t cell, Meeting m, double, double z_far) {
      if (m != Meeting::covers || !hides(facets[i])) return;
      float& cover = grid.cells_[cell].occluder_depth;
      cover = std::min(cover, round_up(z_far + facets[i].depth_tolerance));
    });
  });
}

void CellGrid::Build::fill() {
  const auto kept = [&](std::size_t cell, double z_near) {
    return !options.drop_hidden || !(z_near > grid.cells_[cell].occluder_depth);
  };
  for_each_band([&](int row0, int row1) {
    for_each_meeting(row0, row1, false, [&](std::size_t, std::size_t cell, Meeting, double z_near, double) {
      if (kept(cell, z_near)) ++grid.cells_[cell].count;
    });
  });
  std::uint32_t begin = 0;
  for (Cell& cell : grid.cells_) {
    cell.begin = begin;
    begin += cell.count;
    cell.count = 0;
  }
  auto& list = grid.arenas_[0].list;
  list.resize(begin);
  for_each_band([&](int row0, int row1) {
    for_each_meeting(row0, row1, false, [&](std::size_t i, std::size_t cell, Meeting, double z_near, double) {
      if (!kept(cell, z_near)) return;
      Cell& c = grid.cells_[cell];
      list[c.begin + c.count++] = {static_cast<std::uint32_t>(i), round_down(z_near), {}};
    });
  });
}

/// Facets broader than children of the cell cover some of them and hide what is behind; a crowd of small ones is only
/// spread.
bool CellGrid::Build::worth_splitting(const CellFacet* list, std::size_t n, double size) const {
  if (n <= kLeafFacets || size < kSplitSide * kSmallestCell) return false;
  if (n > kCrowdedFacets) return !of_one_face(list, n);
  if (!options.drop_hidden) return false;
  std::size_t large = 0;
  for (std::size_t i = 0; i < n; ++i) large += breadth(facets[list[i].facet], scene.vertices.data()) > kLargeBreadth * size;
  return static_cast<double>(large) > kLargePart * static_cast<double>(n);
}

void CellGrid::Build::split_overfull() {
  // A fixed number of arenas, so that the structure does not depend on the number of threads.
  constexpr std::size_t kArenas = 64;
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
  const double budget = std::max(kEntriesPerFacet * static_cast<double>(facets.size()), kLeastBudget) / entries;
  parallel_for(kArenas, [&](std::size_t k) {
    Arena& arena = grid.arenas_[k + 1];
    std::vector<CellFacet> inherited;
    CellCover cover(scene, facets, options.margin_steps);
    for (std::size_t i = n * k / kArenas; i < n * (k + 1) / kArenas; ++i) {
      Cell& cell = grid.cells_[i];
      CellFacet* list = grid.arenas_[0].list.data() + cell.begin;
      if (!worth_splitting(list, cell.count, grid.size_)) {
        finish_leaf(cell, list, cell.count, grid.top_square(i), arena.planes);
        continue;
      }
      inherited.assign(list, list + cell.count);
      split(cell, grid.top_square(i), inherited, arena, static_cast<std::uint16_t>(k + 1),
            budget * static_cast<double>(inherited.size()), cover);
    }
  });
  for (Arena& arena : grid.arenas_) grid.planes_.insert(grid.planes_.end(), arena.planes.begin(), arena.planes.end());
  std::sort(grid.planes_.begin(), grid.planes_.end(),
            [](const LeafPlane& a, const LeafPlane& b) { return std::tie(a.arena, a.begin) < std::tie(b.arena, b.begin); });
}

bool CellGrid::Build::of_one_face(const CellFacet* list, std::size_t n) const {
  return std::all_of(list, list + n, [&](const CellFacet& c) { return facets[c.facet].face == facets[list->facet].face; });
}

std::size_t CellGrid::Build::drop_covered(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
                                          CellCover& cover) const {
  if (n <= kLeafFacets || !options.drop_hidden) return n;
  sort_by_depth(list, list + n);
  const auto depth = cover.find(list, n, square, [&](const Facet& f) { return hides(f); });
  if (!depth) return n;
  cell.occluder_depth = std::min(cell.occluder_depth, *depth);
  return static_cast<std::size_t>(
      std::remove_if(list, list + n,
                     [&](const CellFacet& c) { return c.z_near > cell.occluder_depth || cover.hides(facets[c.facet]); }) -
      list);
}

void CellGrid::Build::finish_leaf(Cell& cell, CellFacet* list, std::size_t n, const CellSquare& square,
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

void CellGrid::Build::hand_down(const Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited,
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

void CellGrid::Build::split(Cell& cell, const CellSquare& square, std::vector<CellFacet>& inherited, Arena& arena,
                            std::uint16_t arena_index, double budget, CellCover& cover) {
  Children children;
  hand_down(cell, square, inherited, children);
  std::vector<CellFacet>* lists = children.lists;
  float* covers = children.covers;
  const double size = square.size / kSplitSide;
  std::size_t total = 0;
  for (int k = 0; k < kChildren; ++k) {
    if (options.drop_hidden) std::erase_if(lists[k], [&](const CellFacet& c) { return c.z_near > covers[k]; });
    total += lists[k].size();
  }
  // A line through the cell meets kSplitSide children. A child is split again if the children of this cell save work for
  // such a line, or if its own list is shorter than its parent's was: where many sides lie along one line no split helps.
  // The leaves below the child are expected to have as many entries for one of its own as those of this cell have.
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
  cell.arena = arena_index;
  for (int k = 0; k < kChildren; ++k) {
    Cell child;
    child.occluder_depth = covers[k];
    child.arena = arena_index;
    const CellSquare below = child_square(square, k);
    lists[k].resize(drop_covered(child, lists[k].data(), lists[k].size(), below, cover));
    if (worth_splitting(lists[k].data(), lists[k].size(), size) && progress(lists[k])) {
      split(child, below, lists[k], arena, arena_index,
            budget * static_cast<double>(lists[k].size()) / static_cast<double>(total), cover);
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

CellGrid::CellGrid(const ProjectedScene& scene, const std::vector<Facet>& facets, const Options& options) {
  complete_ = !options.drop_hidden && !options.only_along;
  Build build{scene, facets, options, *this, {}, {}, {}};
  arenas_.resize(1);
  if (!build.choose_cells()) {
    cells_.resize(1);
    return;
  }
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  build.mark_wanted();
  build.find_ranges();
  build.find_occluders();
  build.fill();
  build.split_overfull();
}

const CommonPlane& CellGrid::plane_of(const Cell& cell) const {
  const auto before = [](const LeafPlane& leaf, const Cell& c) {
    return std::tie(leaf.arena, leaf.begin) < std::tie(c.arena, c.begin);
  };
  return std::lower_bound(planes_.begin(), planes_.end(), cell, before)->plane;
}

std::vector<std::uint8_t> CellGrid::listed(std::size_t facets) const {
  std::vector<std::uint8_t> listed(facets);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    for_each_leaf_of(i, [&](const Cell& cell, const CellSquare&) {
      for (std::uint32_t k = 0; k < cell.count; ++k) listed[list(cell)[k].facet] = 1;
    });
  }
  return listed;
}

std::size_t CellGrid::entry_count() const {
  std::size_t n = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    for_each_leaf_of(i, [&](const Cell& cell, const CellSquare&) { n += cell.count; });
  }
  return n;
}

std::size_t CellGrid::leaf_count() const {
  std::size_t n = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) for_each_leaf_of(i, [&](const Cell&, const CellSquare&) { ++n; });
  return n;
}

}  // namespace ligne
