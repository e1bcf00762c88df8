#pragma once
/// The ends of strokes by cells of the page.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "base/portable.hpp"
#include "drawing/graphs/stroke_directions.hpp"

namespace ligne {

/// An end of a common interval of two strokes is an end of one of them and lies on the other, so partners are found by
/// walking along each stroke and looking at the ends in its way. The cells are rectangles of a frame; a cell with many ends
/// gets a grid of its own. Invariant: ends_[first_[c], first_[c + 1]) are those in cell c, equal points together.
class EndGrid {
 public:
  struct End {
    LatticePoint p, far;  ///< the end, and the other end of its stroke
    std::uint32_t stroke;
  };

  /// The wanted cells; sides in lattice steps.
  struct Cells {
    DirectionFrame frame{};
    double least = 1;        ///< side
    double longest = 1;      ///< how many times as long as wide
    bool as_strokes = true;  ///< as long as the strokes are, or longer
    bool is_finer = false;   ///< in a crowd: no longer than leaves each cell an end or two, however long the strokes are
  };

  EndGrid() = default;
  EndGrid(std::vector<End> ends, const Cells& cells);

  /// All, in an order in which ends that are near each other are mostly near each other on the page.
  const std::vector<End>& ends() const { return ends_; }

  /// Within which a point counts as on a line.
  static double reach_of(double tolerance) { return tolerance + kRounding; }
  /// Whether a point is within the margin of the line from-to.
  static bool is_near(LatticePoint p, LatticePoint from, LatticePoint to, double margin) {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, area = orientation(from, to, p);
    return area * area <= margin * margin * (dx * dx + dy * dy);
  }

  /// The stroke that ends here is known to have a partner: its ends need not be looked at by others that have one.
  void settle_end(LatticePoint p);

  /// Calls visit(end) for the ends within the tolerance of the line from-to, but for those at its own two ends. While
  /// settled() is true, cells are passed over in which all ends are of settled strokes: thousands of strokes on one line
  /// look at each other once.
  template <class Settled, class Visit>
  void for_each_along(LatticePoint from, LatticePoint to, double tolerance, const Settled& settled, const Visit& visit) {
    if (!ends_.empty()) walk(from, to, reach_of(tolerance), settled, visit);
  }

 private:
  static constexpr double kRounding = 2;       ///< steps; more than the rounding of any position worked out here
  static constexpr std::uint32_t kCrowd = 64;  ///< adjustable: points in one cell

  bool choose_cells(const std::vector<End>& ends, const Cells& cells);
  /// The first end behind number e, and before `last`, that is elsewhere.
  std::uint32_t next_point(std::uint32_t e, std::uint32_t last) const {
    const LatticePoint p = ends_[e].p;
    if (++e == last || ends_[e].p != p) return e;
    if (++e == last || ends_[e].p != p) return e;  // two ends are what most points have
    return next_of_many(e, last);
  }
  std::uint32_t next_of_many(std::uint32_t e, std::uint32_t last) const;
  void refine_if_crowded(std::size_t c, const Cells& cells);
  EndGrid* finer_in(std::size_t c) {
    if (first_[c + 1] - first_[c] <= kCrowd) return nullptr;
    const std::uint32_t number = finer_number_.find(c);
    return number == kNone ? nullptr : &finer_[number];
  }
  std::size_t cell_of(LatticePoint p) const { return cell_at(column(frame_.u(p)), row(frame_.v(p))); }
  std::size_t cell_at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// Clamped to the grid, all ends of which lie inside.
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
  std::vector<std::uint32_t> open_{0};  ///< per cell, ends of strokes that are not settled
  std::vector<End> ends_;
  KeyTable finer_number_;  ///< by cell
  std::vector<EndGrid> finer_;
};

/// Column by column. The foot of an end on the line is at most the margin from it in x and in y, so in u by no more, and in
/// v, which is sheared by a slope of at most 1, by twice as much.
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
