#pragma once
/// The screen grid: lists for every cell the facets that may be visible in it.
///
/// A uniform grid over the page; overfull cells are split into 4 x 4 children, recursively. Every cell knows the depth
/// of its cover: the nearest facet, or connected patch of facets, that covers it whole (cell_cover.hpp). Facets behind
/// the cover are not listed, and a line behind it needs no further test. Lists include the facets in a margin round the
/// cell, so a line along the border of a cell finds the facets on both of its sides in that cell.
///
/// Invariants: every leaf lists each facet whose projection comes within `margin` of it, unless the facet is behind the
/// leaf's cover, or both it and a listed facet of a lower face cover the leaf and coincide there. Lists are ordered by
/// z_near. A child's cover is not behind its parent's.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "visibility/common/cell_facet.hpp"
#include "visibility/common/common_plane.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// A rectangle of the page.
struct PageRange {
  double x0, y0, x1, y1;
};

struct Cell {
  static constexpr std::uint32_t kSplit = 0xffffffffu;
  std::uint32_t begin = 0;  ///< first entry of the list, or first child, in the arena
  std::uint32_t count = 0;  ///< length of the list, or kSplit
  float occluder_depth = std::numeric_limits<float>::infinity();
  std::uint8_t arena = 0;
  /// Facets that begin before `occluder_depth` were dropped, since the patch hides them by its planes.
  bool dropped_by_planes = false;
  bool one_face = false;   ///< all facets of the list are of one face
  bool one_plane = false;  ///< the list is long, and its facets lie in one plane; see CellGrid::plane_of()
};

inline constexpr int kSplitSide = 4;

class CellGrid {
 public:
  struct Options {
    double margin_steps = 0;
    /// Drop facets behind the cover from the lists. Off when hidden intersections are wanted, too.
    bool drop_hidden = true;
    bool see_through = false;  ///< transparent faces cover nothing
    /// If not null, only the cells that these lines run through are filled.
    const std::vector<ProjectedEdge>* only_along = nullptr;

    bool hides(const ProjectedScene& scene, const Facet& f) const {
      return !see_through || scene.face_is_transparent.empty() || !scene.face_is_transparent[f.face];
    }
  };

  CellGrid(const ProjectedScene& scene, const std::vector<Facet>& facets, const Options& options);

  /// Calls visit(cell, square, from, to) for every leaf that the line runs through, in order, and for split cells whose
  /// cover hides the line there. [from, to] is the line's part in the cell; neighbouring parts share their ends to the
  /// last bit.
  template <class Visit>
  void for_each_leaf(const PageLine& line, Visit visit) const;

  /// Calls visit(cell, square) for every leaf below top-level cell i.
  template <class Visit>
  void for_each_leaf_of(std::size_t i, Visit visit) const;

  /// Calls visit(cell, square) for every leaf that meets the rectangle [x0, x1] x [y0, y1].
  template <class Visit>
  void for_each_leaf_in(double x0, double y0, double x1, double y1, Visit visit) const;

  /// Whether every list holds all facets that meet its cell, the hidden ones too.
  bool complete() const { return complete_; }
  std::size_t top_cell_count() const { return cells_.size(); }
  const CellFacet* list(const Cell& cell) const { return arenas_[cell.arena].list.data() + cell.begin; }
  /// The common plane of the facets of a leaf; `one_plane` must be true.
  const CommonPlane& plane_of(const Cell& cell) const;
  /// Per facet: 1 if any leaf lists it. Unlisted facets are invisible, and hide nothing visible.
  std::vector<std::uint8_t> listed(std::size_t facets) const;
  std::size_t entry_count() const;
  std::size_t leaf_count() const;

 private:
  struct LeafPlane {
    std::uint8_t arena;
    std::uint32_t begin;  ///< of the leaf's list in the arena
    CommonPlane plane;
  };
  struct Arena {
    std::vector<Cell> children;
    std::vector<CellFacet> list;
    std::vector<LeafPlane> planes;
  };
  struct Filler;
  struct Splitter;

  // Adjustable parameters.
  static constexpr double kSmallestCell = 64;  ///< least side of a cell, in lattice steps
  /// Approximate limit on the number of entries of all leaves.
  static double most_entries(std::size_t facets) { return std::max(64 * static_cast<double>(facets), 2.5e5); }

  void split_overfull(const ProjectedScene& scene, const std::vector<Facet>& facets, const Options& options);

  /// A block of cells of equal size: the whole grid, or the children of a split cell.
  struct Cells {
    double x, y, size;  ///< corner of the first cell, and side of all
    int columns, rows;
    const Cell* cells;

    const Cell& at(int column, int row) const { return cells[static_cast<std::size_t>(row) * columns + column]; }
    CellSquare square(int column, int row) const { return {x + column * size, y + row * size, size}; }
  };
  Cells top_cells() const { return {x_, y_, size_, columns_, rows_, cells_.data()}; }
  Cells cells_of(const Cell& split, const CellSquare& square) const {
    return {square.x,   square.y,   square.size / kSplitSide,
            kSplitSide, kSplitSide, arenas_[split.arena].children.data() + split.begin};
  }
  template <class Visit>
  void walk(const PageLine& line, const Cells& cells, double from, double to, const Visit& visit) const;
  template <class Visit>
  void visit_leaves(const Cell& cell, const CellSquare& square, const Visit& visit) const;
  template <class Visit>
  void visit_leaves_in(const Cells& cells, const PageRange& range, const Visit& visit) const;
  CellSquare top_square(std::size_t i) const {
    return {x_ + double(i % columns_) * size_, y_ + double(i / columns_) * size_, size_};
  }

  double x_ = 0, y_ = 0, size_ = 1;
  int columns_ = 1, rows_ = 1;
  bool complete_ = false;
  std::vector<Cell> cells_;
  std::vector<Arena> arenas_;
  std::vector<LeafPlane> planes_;  ///< by arena and begin
};

template <class Visit>
void CellGrid::for_each_leaf(const PageLine& line, Visit visit) const {
  walk(line, top_cells(), 0, 1, visit);
}

/// Walks a uniform grid along the line. Each step crosses the nearer of the next vertical and the next horizontal
/// border.
template <class Visit>
void CellGrid::walk(const PageLine& line, const Cells& cells, double from, double to, const Visit& visit) const {
  const double x = cells.x, y = cells.y, size = cells.size;
  const int columns = cells.columns, rows = cells.rows;
  const double inverse = 1 / size;
  const double x0 = line.p0.x, y0 = line.p0.y;
  const double dx = line.dx, dy = line.dy;
  const auto clamped = [](double v, int n) { return v < 0 ? 0 : v >= n ? n - 1 : static_cast<int>(v); };
  int column = clamped((x0 + from * dx - x) * inverse, columns);
  int row = clamped((y0 + from * dy - y) * inverse, rows);
  const int last_column = clamped((x0 + to * dx - x) * inverse, columns);
  const int last_row = clamped((y0 + to * dy - y) * inverse, rows);
  const int step_x = last_column >= column ? 1 : -1, step_y = last_row >= row ? 1 : -1;
  const auto border_t = [](double border, double origin, double d) { return (border - origin) / d; };
  double t = from;
  while (true) {
    double next = to;
    bool across = false, down = false;
    if (column != last_column) {
      next = border_t(x + (column + (step_x > 0)) * size, x0, dx);
      across = true;
    }
    if (row != last_row) {
      const double next_y = border_t(y + (row + (step_y > 0)) * size, y0, dy);
      if (!across || next_y < next) {
        next = next_y;
        across = false;
        down = true;
      }
    }
    next = next < t ? t : next > to ? to : next;
    if (t < next || from == to) {
      const Cell& cell = cells.at(column, row);
      const CellSquare square = cells.square(column, row);
      if (cell.count == Cell::kSplit) {
        if (cell.occluder_depth < line.z(t) && cell.occluder_depth < line.z(next)) {
          visit(cell, square, t, next);
        } else {
          walk(line, cells_of(cell, square), t, next, visit);
        }
      } else {
        visit(cell, square, t, next);
      }
    }
    t = next;
    if (!across && !down) return;
    if (across) column += step_x;
    if (down) row += step_y;
  }
}

template <class Visit>
void CellGrid::for_each_leaf_of(std::size_t i, Visit visit) const {
  visit_leaves(cells_[i], top_square(i), visit);
}

template <class Visit>
void CellGrid::visit_leaves(const Cell& cell, const CellSquare& square, const Visit& visit) const {
  if (cell.count != Cell::kSplit) {
    visit(cell, square);
    return;
  }
  const double child = square.size / kSplitSide;
  for (int k = 0; k < kSplitSide * kSplitSide; ++k) {
    visit_leaves(arenas_[cell.arena].children[cell.begin + k],
                 {square.x + (k % kSplitSide) * child, square.y + (k / kSplitSide) * child, child}, visit);
  }
}

template <class Visit>
void CellGrid::for_each_leaf_in(double x0, double y0, double x1, double y1, Visit visit) const {
  visit_leaves_in(top_cells(), {x0, y0, x1, y1}, visit);
}

template <class Visit>
void CellGrid::visit_leaves_in(const Cells& cells, const PageRange& range, const Visit& visit) const {
  const auto clamped = [](double v, int n) { return v < 0 ? 0 : v >= n ? n - 1 : static_cast<int>(v); };
  const auto column_at = [&](double x) { return clamped((x - cells.x) / cells.size, cells.columns); };
  const auto row_at = [&](double y) { return clamped((y - cells.y) / cells.size, cells.rows); };
  const int left = column_at(range.x0), right = column_at(range.x1), top = row_at(range.y0), bottom = row_at(range.y1);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      const Cell& cell = cells.at(column, row);
      const CellSquare square = cells.square(column, row);
      if (cell.count == Cell::kSplit) {
        visit_leaves_in(cells_of(cell, square), range, visit);
      } else {
        visit(cell, square);
      }
    }
  }
}

}  // namespace ligne
