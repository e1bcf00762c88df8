#pragma once
/// A grid over the page that finds the stroke ends near a line.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "base/portable.hpp"
#include "linework/overlaps/stroke_directions.hpp"

namespace ligne {

/// Two strokes overlap if they share an interval, that is, lie on each other over some length. Each end of that interval
/// is an end of one stroke that lies on the other stroke. So overlaps are found by walking along each stroke and looking
/// at the ends within the tolerance of it. The cells are rectangles in the coordinates of a DirectionFrame.
/// A cell with ends at many different points gets a finer grid of its own. Invariant: cell c holds the elements
/// [first_[c], first_[c + 1]) of ends_, and ends at equal points are adjacent.
class EndGrid {
 public:
  struct End {
    LatticePoint p, far;  ///< the end, and the other end of its stroke
    std::uint32_t stroke;
  };

  /// Constraints on the cells. Lengths are in lattice steps. A cell's length is its side along u, its width the side
  /// along v.
  struct Cells {
    DirectionFrame frame{};
    double least = 1;        ///< shortest side
    double longest = 1;      ///< largest ratio of length to width
    bool as_strokes = true;  ///< cells are at least about as long as the median stroke
    bool is_finer = false;   ///< for the finer grid of one cell: about one end per cell matters more than as_strokes
  };

  EndGrid() = default;
  EndGrid(std::vector<End> ends, const Cells& cells);

  /// All ends, cell by cell, so that neighbours in the list are mostly neighbours on the page.
  const std::vector<End>& ends() const { return ends_; }

  /// Largest distance at which a point counts as on a line, lattice steps: the tolerance plus the rounding of
  /// positions.
  static double reach_of(double tolerance) { return tolerance + kRounding; }
  /// Whether the distance of p from the infinite line through `from` and `to` is at most the margin, lattice steps.
  static bool is_near(LatticePoint p, LatticePoint from, LatticePoint to, double margin) {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, area = orientation(from, to, p);
    return area * area <= margin * margin * (dx * dx + dy * dy);
  }

  /// Records that a stroke with an end at p overlaps another one, which settles it. Call it once for each end of the
  /// stroke.
  void settle_end(LatticePoint p);

  /// Calls visit(end) for the ends within the tolerance of the segment from-to, except for ends at `from` or at `to`.
  /// settled() says whether an overlap of the searching stroke is known already. As long as it returns true, the walk skips
  /// cells in which all strokes are settled, so that thousands of strokes on one line do not all visit each other.
  template <class Settled, class Visit>
  void for_each_along(LatticePoint from, LatticePoint to, double tolerance, const Settled& settled, const Visit& visit) {
    if (!ends_.empty()) walk(from, to, reach_of(tolerance), settled, visit);
  }

 private:
  static constexpr double kRounding = 2;                ///< lattice steps; more than the rounding error of any position here
  static constexpr std::uint32_t kMaxCellEntries = 64;  ///< distinct points above which a cell gets a finer grid; adjustable

  bool choose_cells(const std::vector<End>& ends, const Cells& cells);
  /// Index of the first end after e that lies at another point than end e; `last` if there is none before it.
  std::uint32_t next_point(std::uint32_t e, std::uint32_t last) const {
    const LatticePoint p = ends_[e].p;
    if (++e == last || ends_[e].p != p) return e;
    if (++e == last || ends_[e].p != p) return e;  // most points have two ends
    return next_of_many(e, last);
  }
  /// Continues next_point() where more than two ends lie at one point.
  std::uint32_t next_of_many(std::uint32_t e, std::uint32_t last) const;
  void refine_if_full(std::size_t c, const Cells& cells);
  EndGrid* finer_in(std::size_t c) {
    if (first_[c + 1] - first_[c] <= kMaxCellEntries) return nullptr;
    const std::uint32_t number = finer_number_.find(c);
    return number == kNone ? nullptr : &finer_[number];
  }
  std::size_t cell_of(LatticePoint p) const { return cell_at(column(frame_.u(p)), row(frame_.v(p))); }
  std::size_t cell_at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// Column and row of a position, clamped to the grid; all ends lie inside the grid.
  int column(double u) const { return clamped((u - low_u_) / side_u_, columns_); }
  int row(double v) const { return clamped((v - low_v_) / side_v_, rows_); }
  static int clamped(double part, int n) { return part < 0 ? 0 : part >= n ? n - 1 : static_cast<int>(part); }

  template <class Settled, class Visit>
  void walk(LatticePoint from, LatticePoint to, double margin, const Settled& settled, const Visit& visit);
  template <class Settled>
  bool passed_over(std::size_t c, const Settled& settled) {
    return first_[c] == first_[c + 1] ||
           (settled() && AtomicRef<const std::uint32_t>(open_[c]).load(std::memory_order_relaxed) == 0);
  }

  DirectionFrame frame_;
  double low_u_ = 0, low_v_ = 0, side_u_ = 1, side_v_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_{0, 0};
  std::vector<std::uint32_t> open_{0};  ///< per cell: number of ends whose strokes are not settled
  std::vector<End> ends_;
  KeyTable finer_number_;  ///< cell to the index of its finer grid in finer_
  std::vector<EndGrid> finer_;
};

/// Walks column by column. The foot of an end's perpendicular on the line is at most the margin away from the end in x
/// and in y. So it is at most the margin away in u. In v, which is sheared by a slope of at most 1, it is at most twice
/// the margin away.
template <class Settled, class Visit>
void EndGrid::walk(LatticePoint from, LatticePoint to, double margin, const Settled& settled, const Visit& visit) {
  double u0 = frame_.u(from), v0 = frame_.v(from), u1 = frame_.u(to), v1 = frame_.v(to);
  if (u0 > u1) {
    std::swap(u0, u1);
    std::swap(v0, v1);
  }
  const double low = std::min(v0, v1), high = std::max(v0, v1);
  if (u1 + margin < low_u_ || u0 - margin >= low_u_ + columns_ * side_u_) return;
  if (high + 2 * margin < low_v_ || low - 2 * margin >= low_v_ + rows_ * side_v_) return;
  const double slope = u1 > u0 ? (v1 - v0) / (u1 - u0) : 0;
  const int last_column = column(u1 + margin);
  for (int i = column(u0 - margin); i <= last_column; ++i) {
    double v_from = low, v_to = high;
    if (u1 > u0) {
      const double a = v0 + (std::max(u0, low_u_ + i * side_u_ - margin) - u0) * slope;
      const double b = v0 + (std::min(u1, low_u_ + (i + 1) * side_u_ + margin) - u0) * slope;
      v_from = std::clamp(std::min(a, b), low, high);
      v_to = std::clamp(std::max(a, b), low, high);
    }
    const int last_row = row(v_to + 2 * margin);
    for (int j = row(v_from - 2 * margin); j <= last_row; ++j) {
      const std::size_t c = cell_at(i, j);
      if (passed_over(c, settled)) continue;
      if (EndGrid* const finer = finer_in(c)) {
        finer->walk(from, to, margin, settled, visit);
        continue;
      }
      for (std::uint32_t e = first_[c]; e < first_[c + 1];) {
        const LatticePoint p = ends_[e].p;
        const bool along = p != from && p != to && is_near(p, from, to, margin);
        const std::uint32_t next = next_point(e, first_[c + 1]);
        for (; along && e < next; ++e) visit(ends_[e]);
        e = next;
      }
    }
  }
}

}  // namespace ligne
