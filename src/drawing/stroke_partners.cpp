#include "drawing/stroke_partners.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "drawing/key_table.hpp"
#include "drawing/stroke_index.hpp"
#include "drawing/stroke_overlap.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

constexpr std::size_t kGrain = 4096;

/// A coarse raster of the page in which strokes are marked: most strokes of a large drawing lie in no marked square, and
/// this is found out faster than in a hash table.
class MarkedSquares {
 public:
  MarkedSquares(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double margin)
      : marks_(kSide * kSide, 0), margin_(margin) {
    for (const std::uint32_t i : of) {
      const bool too_large = for_each_square(strokes[i], [&](std::size_t k) {
        marks_[k] = 1;
        return false;
      });
      everywhere_ = everywhere_ || too_large;
    }
  }
  /// May the stroke lie on one of those marked? True where that would take long to decide.
  bool near(const Stroke& s) const {
    return everywhere_ || for_each_square(s, [&](std::size_t k) { return marks_[k] != 0; });
  }

 private:
  static constexpr std::size_t kSide = 2048;
  static constexpr std::size_t kLargest = 256;  ///< bounding boxes of more squares are not looked at

  std::size_t square(double v) const {
    return static_cast<std::size_t>((v + kLatticeLimit) * (double(kSide) / (2.0 * kLatticeLimit + 1)));
  }
  /// Squares of the stroke's bounding box, until visit returns true; true too when there are too many.
  template <class Visit>
  bool for_each_square(const Stroke& s, const Visit& visit) const {
    const double limit = kLatticeLimit;
    const std::size_t left = square(std::max(std::min(s.from.x, s.to.x) - margin_, -limit));
    const std::size_t right = square(std::min(std::max(s.from.x, s.to.x) + margin_, limit));
    const std::size_t top = square(std::max(std::min(s.from.y, s.to.y) - margin_, -limit));
    const std::size_t bottom = square(std::min(std::max(s.from.y, s.to.y) + margin_, limit));
    if ((bottom - top + 1) * (right - left + 1) > kLargest) return true;
    for (std::size_t y = top; y <= bottom; ++y) {
      for (std::size_t x = left; x <= right; ++x) {
        if (visit(y * kSide + x)) return true;
      }
    }
    return false;
  }

  std::vector<std::uint8_t> marks_;
  double margin_;
  bool everywhere_ = false;
};

/// The ends of strokes by cells of the page: an end of a common interval is an end of one of the two strokes and lies on the
/// other, so partners are found by walking along each stroke and looking at the ends in its way.
class EndGrid {
 public:
  struct End {
    LatticePoint p;
    std::uint32_t stroke;
  };

  /// `cell`: side of the cells, at least; `least_cell`: that of cells where there is a crowd.
  EndGrid(const std::vector<End>& ends, double cell, double least_cell) : cell_(cell) {
    LatticePoint low{kLatticeLimit, kLatticeLimit}, high{-kLatticeLimit, -kLatticeLimit};
    for (const End& e : ends) {
      low = {std::min(low.x, e.p.x), std::min(low.y, e.p.y)};
      high = {std::max(high.x, e.p.x), std::max(high.y, e.p.y)};
    }
    const double columns = std::min(kMostColumns, std::ceil(2 * std::sqrt(0.5 * static_cast<double>(ends.size()))));
    cell_ = std::max(cell_, std::ceil(std::max(double(high.x) - low.x, double(high.y) - low.y) / columns));
    range_ = {index(low.x), index(low.y), index(high.x), index(high.y)};
    columns_ = range_.column1 - range_.column0 + 1;
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(range_.row1 - range_.row0 + 1) + 1, 0);
    for (const End& e : ends) ++first_[cell_of(e.p) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    ends_.resize(first_.back());
    open_.resize(first_.size() - 1);
    for (std::size_t c = 0; c < open_.size(); ++c) open_[c] = first_[c + 1] - first_[c];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const End& e : ends) ends_[next[cell_of(e.p)]++] = e;
    // Equal points stand together, so that a point where thousands of strokes meet is passed by at once.
    parallel_blocks(first_.size() - 1, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        std::sort(ends_.begin() + first_[c], ends_.begin() + first_[c + 1], [](const End& a, const End& b) {
          return std::tie(a.p.x, a.p.y, a.stroke) < std::tie(b.p.x, b.p.y, b.stroke);
        });
      }
    });
    for (std::size_t c = 0; c + 1 < first_.size(); ++c) refine_if_crowded(c, least_cell);
  }

  /// The stroke is known to have a partner: its ends need not be looked at by others that have one.
  void settle(const Stroke& s) {
    settle_end(s.from);
    settle_end(s.to);
  }

  /// Calls visit(stroke) for the ends within the tolerance of the line of `s`, but for those at its own two ends. While
  /// settled() is true, cells are passed over in which all ends are of settled strokes: thousands of strokes on one line
  /// look at each other once.
  template <class Settled, class Visit>
  void for_each_along(const Stroke& s, double tolerance, const Settled& settled, const Visit& visit) {
    const SegmentGrid grid(cell_, tolerance);
    const double stroke_length = length(s.from, s.to);
    grid.walk_cells(s.from, s.to, range_, [&](std::int32_t column, std::int32_t row) {
      const std::size_t c = number_of(column, row);
      if (settled() && std::atomic_ref(open_[c]).load(std::memory_order_relaxed) == 0) return false;
      if (EndGrid* const finer = finer_in(c)) {
        finer->for_each_along(s, tolerance, settled, visit);
        return false;
      }
      for (std::uint32_t e = first_[c]; e < first_[c + 1];) {
        const LatticePoint p = ends_[e].p;
        const bool along = p != s.from && p != s.to && grid.near(p, s.from, s.to, stroke_length);
        const std::uint32_t next = next_point(e, first_[c + 1]);
        for (; along && e < next; ++e) visit(ends_[e].stroke);
        e = next;
      }
      return false;
    });
  }

 private:
  static constexpr double kMostColumns = 2048;
  static constexpr std::uint32_t kCrowd = 256;  ///< adjustable: points in one cell

  /// The first end behind number e, and before `last`, that is elsewhere: by doubling steps, since thousands may be alike.
  std::uint32_t next_point(std::uint32_t e, std::uint32_t last) const {
    const LatticePoint p = ends_[e].p;
    std::uint32_t step = 1;
    while (e + step < last && ends_[e + step].p == p) step *= 2;
    const auto from = ends_.begin() + e + step / 2, to = ends_.begin() + std::min(last, e + step);
    return static_cast<std::uint32_t>(std::partition_point(from, to, [&](const End& end) { return end.p == p; }) -
                                      ends_.begin());
  }

  /// A cell with many points gets a grid of its own, where that has much smaller cells.
  void refine_if_crowded(std::size_t c, double least_cell) {
    if (first_[c + 1] - first_[c] <= kCrowd || cell_ < 2 * least_cell) return;
    std::uint32_t points = 0;
    for (std::uint32_t e = first_[c]; e < first_[c + 1]; e = next_point(e, first_[c + 1])) ++points;
    if (points <= kCrowd) return;
    finer_number_[c] = static_cast<std::uint32_t>(finer_.size());
    finer_.emplace_back(std::vector<End>(ends_.begin() + first_[c], ends_.begin() + first_[c + 1]), least_cell, least_cell);
  }
  EndGrid* finer_in(std::size_t c) {
    if (first_[c + 1] - first_[c] <= kCrowd) return nullptr;
    const std::uint32_t number = finer_number_.find(c);
    return number == KeyTable::kNone ? nullptr : &finer_[number];
  }

  void settle_end(LatticePoint p) {
    const std::size_t c = cell_of(p);
    std::atomic_ref(open_[c]).fetch_sub(1, std::memory_order_relaxed);
    if (EndGrid* const finer = finer_in(c)) finer->settle_end(p);
  }

  std::int32_t index(double v) const { return static_cast<std::int32_t>(std::floor(v / cell_)); }
  std::size_t number_of(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row - range_.row0) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column - range_.column0);
  }
  std::size_t cell_of(LatticePoint p) const { return number_of(index(p.x), index(p.y)); }

  double cell_;
  CellRange range_;
  std::int32_t columns_ = 0;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> open_;  ///< per cell, ends of strokes that are not settled
  std::vector<End> ends_;
  KeyTable finer_number_;  ///< by cell
  std::vector<EndGrid> finer_;
};

/// Both ends of the strokes numbered in `of`.
std::vector<EndGrid::End> ends_of(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of) {
  std::vector<EndGrid::End> ends;
  ends.reserve(2 * of.size());
  for (const std::uint32_t i : of) {
    for (const LatticePoint p : {strokes[i].from, strokes[i].to}) ends.push_back({p, i});
  }
  return ends;
}

/// Marks the strokes that share both ends with another one.
template <class Mark>
void mark_same_ends(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, const Mark& mark) {
  struct Ends {
    std::uint64_t low, high;
    std::uint32_t stroke;
    auto pair() const { return std::tie(low, high); }
  };
  std::vector<Ends> ends(of.size());
  const auto key = [](LatticePoint p) {
    return std::uint64_t(static_cast<std::uint32_t>(p.x)) << 32 | static_cast<std::uint32_t>(p.y);
  };
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto [low, high] = std::minmax({key(strokes[of[i]].from), key(strokes[of[i]].to)});
    ends[i] = {low, high, of[i]};
  }
  parallel_sort(ends.begin(), ends.end(), [](const Ends& a, const Ends& b) {
    return std::tie(a.low, a.high, a.stroke) < std::tie(b.low, b.high, b.stroke);
  });
  for (std::size_t begin = 0; begin < ends.size();) {
    std::size_t end = begin;
    bool flagged = false;
    for (; end < ends.size() && ends[end].pair() == ends[begin].pair(); ++end) {
      flagged = flagged || strokes[ends[end].stroke].may_coincide;
    }
    if (flagged && end - begin > 1) {
      for (std::size_t k = begin; k < end; ++k) mark(ends[k].stroke);
    }
    begin = end;
  }
}

/// The strokes that may coincide, and those near them, in order.
std::vector<std::uint32_t> find_candidates(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<std::uint32_t> flagged;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].may_coincide && length(strokes[i].from, strokes[i].to) > tolerance_steps) flagged.push_back(i);
  }
  if (flagged.empty() || flagged.size() == strokes.size()) return flagged;
  const MarkedSquares squares(strokes, flagged, tolerance_steps);
  std::vector<std::uint8_t> near(strokes.size(), 0);
  parallel_blocks(strokes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Stroke& s = strokes[i];
      near[i] = length(s.from, s.to) > tolerance_steps && (s.may_coincide || squares.near(s));
    }
  });
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (near[i]) result.push_back(i);
  }
  return result;
}

}  // namespace

std::vector<Partners> find_partners(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<Partners> result(strokes.size(), Partners::cannot);
  const std::vector<std::uint32_t> candidates = find_candidates(strokes, tolerance_steps);
  if (candidates.empty()) return result;
  for (const std::uint32_t i : candidates) {
    if (strokes[i].may_coincide) result[i] = Partners::none;
  }
  EndGrid ends(ends_of(strokes, candidates), index_cell(strokes, candidates, tolerance_steps),
               kLeastCellInTolerances * tolerance_steps);
  const auto has_partner = [&](std::uint32_t i) {
    return std::atomic_ref(result[i]).load(std::memory_order_relaxed) == Partners::some;
  };
  const auto mark = [&](std::uint32_t i) {
    const Partners before = std::atomic_ref(result[i]).exchange(Partners::some, std::memory_order_relaxed);
    if (before != Partners::some) ends.settle(strokes[i]);
  };
  parallel_blocks(candidates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = candidates[k];
      const Stroke& s = strokes[i];
      const auto settled = [&] { return has_partner(i); };
      ends.for_each_along(s, tolerance_steps, settled, [&](std::uint32_t other) {
        const Stroke& o = strokes[other];
        if (other == i || !(s.may_coincide || o.may_coincide) || (settled() && has_partner(other))) return;
        if (!overlap(s.from, s.to, o.from, o.to, tolerance_steps)) return;
        mark(i);
        mark(other);
      });
    }
  });
  mark_same_ends(strokes, candidates, mark);
  return result;
}

}  // namespace ligne
