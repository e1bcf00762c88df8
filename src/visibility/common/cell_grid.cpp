#include "visibility/common/cell_grid.hpp"

#include <cmath>
#include <tuple>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "visibility/common/facet_in_cell.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
constexpr double kSizeFactor = 1.5;     ///< side of a top-level cell over the mean extent of a facet
constexpr double kCellsPerFacet = 1.0;  ///< largest number of top-level cells per facet
constexpr double kMinCells = 256;
constexpr std::size_t kFacetsPerBlock = 65'536;
/// Facets per band of rows, each of which a task fills. Every task passes all facets.
constexpr std::size_t kFacetsPerBand = 16'384;
constexpr std::size_t kMostBands = 4;

}  // namespace

/// Chooses the cells of the uniform grid and fills their lists.
struct CellGrid::Filler {
  struct Range {
    std::uint16_t column0, column1, row0, row1;
  };
  struct Rows {
    int begin, end;
  };

  const ProjectedScene& scene;
  const std::vector<Facet>& facets;
  const Options& options;
  CellGrid& grid;
  std::vector<std::uint8_t> wanted;   ///< per top-level cell: 1 if it is filled; empty if all are
  std::vector<std::uint32_t> listed;  ///< if only some cells are filled: the facets whose range contains one
  std::vector<Range> ranges;          ///< ranges of cells of all facets, or of those in `listed`, with the margin

  bool hides(const Facet& f) const { return options.hides(scene, f); }
  bool choose_cells();
  void mark_wanted();
  Range range_of(const Facet& f) const;
  bool is_wanted(const Range& r) const;
  void find_ranges();
  /// Number of facets that the grid takes, and the index of the k-th.
  std::size_t filed() const { return wanted.empty() ? facets.size() : listed.size(); }
  std::size_t facet_number(std::size_t k) const { return wanted.empty() ? k : listed[k]; }
  void find_occluders();
  void fill();
  /// Divides the rows into bands: calls work(rows). One task fills a band and scans all facets, so lists keep the order of
  /// the facets.
  template <class Work>
  void for_each_band(Work work) const {
    const std::size_t count = std::clamp<std::size_t>(facets.size() / kFacetsPerBand, 1, kMostBands);
    parallel_tasks(count, [&](std::size_t band) {
      const int b = static_cast<int>(band), bands = static_cast<int>(count);
      work(Rows{grid.rows_ * b / bands, grid.rows_ * (b + 1) / bands});
    });
  }
  /// Calls visit(facet, cell, meeting, z_near, z_far) for all cells in some rows that facets meet.
  template <class Visit>
  void for_each_meeting(Rows band, bool large_only, Visit visit) const;
};

bool CellGrid::Filler::choose_cells() {
  /// Sums over all facets of width plus height, of area and of the length of the outline; and their bounding box.
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
  // A large facet lies in about area / size^2 + outline / size cells; the sum must stay within the limit.
  const double limit = most_entries(facets.size()) / 2;
  size = std::max(size, (outline + std::sqrt(outline * outline + 4 * limit * area)) / (2 * limit));
  // A whole number of steps, so that cell borders are exact.
  grid.size_ = std::ceil(size);
  grid.x_ = x0;
  grid.y_ = y0;
  grid.columns_ = static_cast<int>(width / grid.size_) + 1;
  grid.rows_ = static_cast<int>(height / grid.size_) + 1;
  return true;
}

void CellGrid::Filler::mark_wanted() {
  if (!options.only_along) return;
  wanted.assign(grid.cells_.size(), 0);
  for (const ProjectedEdge& edge : *options.only_along) {
    const PageLine line(scene.vertices[edge.v0], scene.vertices[edge.v1], kNone, kNone);
    grid.for_each_leaf(line, [&](const Cell& cell, const CellSquare&, double, double) {
      wanted[static_cast<std::size_t>(&cell - grid.cells_.data())] = 1;
    });
  }
}

CellGrid::Filler::Range CellGrid::Filler::range_of(const Facet& f) const {
  const double inverse = 1 / grid.size_, margin = options.margin_steps;
  const auto clamped = [](double v, int n) { return static_cast<std::uint16_t>(v < 0 ? 0 : v >= n ? n - 1 : v); };
  const auto [left, right, top, bottom] = page_box(f, scene.vertices.data());
  return {clamped((left - margin - grid.x_) * inverse, grid.columns_),
          clamped((right + margin - grid.x_) * inverse, grid.columns_),
          clamped((top - margin - grid.y_) * inverse, grid.rows_),
          clamped((bottom + margin - grid.y_) * inverse, grid.rows_)};
}

bool CellGrid::Filler::is_wanted(const Range& r) const {
  for (int row = r.row0; row <= r.row1; ++row) {
    const auto first = wanted.begin() + static_cast<std::ptrdiff_t>(row) * grid.columns_;
    const auto last = first + r.column1 + 1;
    if (std::find(first + r.column0, last, 1) != last) return true;
  }
  return false;
}

void CellGrid::Filler::find_ranges() {
  if (!wanted.empty()) {
    listed = indices_where(facets.size(), [&](std::size_t i) { return is_wanted(range_of(facets[i])); });
  }
  ranges = large_vector<Range>(filed());
  parallel_each(filed(), [&](std::size_t k) { ranges[k] = range_of(facets[facet_number(k)]); });
}

template <class Visit>
void CellGrid::Filler::for_each_meeting(Rows band, bool large_only, Visit visit) const {
  for (std::size_t k = 0; k < filed(); ++k) {
    const std::size_t i = facet_number(k);
    const Range r = ranges[k];
    if (r.row1 < band.begin || r.row0 >= band.end) continue;
    const int columns = r.column1 - r.column0 + 1, rows = r.row1 - r.row0 + 1;
    if (large_only && (columns < 3 || rows < 3)) continue;
    const Facet& f = facets[i];
    const int row0 = std::max<int>(r.row0, band.begin), row1 = std::min<int>(r.row1, band.end - 1);
    if (columns == 1 || rows == 1 || columns * rows <= 4) {
      for (int row = row0; row <= row1; ++row) {
        for (int column = r.column0; column <= r.column1; ++column) {
          const std::size_t cell = static_cast<std::size_t>(row) * grid.columns_ + column;
          if (!wanted.empty() && !wanted[cell]) continue;
          visit(i, cell, Meeting::meets, f.z_near, f.z_far);
        }
      }
      continue;
    }
    const FacetFunctions g(f, scene.vertices.data());
    for (int row = row0; row <= row1; ++row) {
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

void CellGrid::Filler::find_occluders() {
  for_each_band([&](Rows rows) {
    for_each_meeting(rows, true, [&](std::size_t i, std::size_t cell, Meeting m, double, double z_far) {
      if (m != Meeting::covers || !hides(facets[i])) return;
      float& cover = grid.cells_[cell].occluder_depth;
      cover = std::min(cover, round_up(z_far + facets[i].depth_tolerance));
    });
  });
}

void CellGrid::Filler::fill() {
  const auto kept = [&](std::size_t cell, double z_near) {
    return !options.drop_hidden || !(z_near > grid.cells_[cell].occluder_depth);
  };
  for_each_band([&](Rows rows) {
    for_each_meeting(rows, false, [&](std::size_t, std::size_t cell, Meeting, double z_near, double) {
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
  for_each_band([&](Rows rows) {
    for_each_meeting(rows, false, [&](std::size_t i, std::size_t cell, Meeting, double z_near, double) {
      if (!kept(cell, z_near)) return;
      Cell& c = grid.cells_[cell];
      list[c.begin + c.count++] = {static_cast<std::uint32_t>(i), round_down(z_near), {}};
    });
  });
}

CellGrid::CellGrid(const ProjectedScene& scene, const std::vector<Facet>& facets, const Options& options) {
  complete_ = !options.drop_hidden && !options.only_along;
  Filler filler{scene, facets, options, *this, {}, {}, {}};
  arenas_.resize(1);
  if (!filler.choose_cells()) {
    cells_.resize(1);
    return;
  }
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  filler.mark_wanted();
  filler.find_ranges();
  filler.find_occluders();
  filler.fill();
  split_overfull(scene, facets, options);
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
