#include "linework/overlaps/overlapping_strokes.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "base/portable.hpp"
#include "linework/overlaps/end_grid.hpp"
#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/overlaps/stroke_tree.hpp"

namespace ligne {
namespace {

constexpr std::size_t kStrokesPerTask = 4096;

/// A coarse raster of the page that marks the squares through which strokes pass. Most strokes of a large drawing lie
/// in no marked square, and the raster finds this faster than a hash table. The fewer strokes, the fewer squares, since
/// they must be cleared.
class MarkedSquares {
 public:
  MarkedSquares(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double margin)
      : side_(side_for(strokes.size())), marks_(side_ * side_, 0), margin_(margin + 1) {
    for (const std::uint32_t i : of) {
      for_each_square(strokes[i], [&](std::size_t k) {
        marks_[k] = 1;
        return false;
      });
    }
  }
  /// Whether the stroke may lie on a marked stroke.
  bool near(const Stroke& s) const {
    return for_each_square(s, [&](std::size_t k) { return marks_[k] != 0; });
  }

 private:
  static constexpr double kPageSteps = 2.0 * kLatticeLimit + 1;

  /// About 64 squares for each stroke.
  static std::size_t side_for(std::size_t strokes) {
    std::size_t side = 16;
    while (side < 2048 && side * side < 64 * strokes) side *= 2;
    return side;
  }

  std::size_t square(double v) const {
    constexpr double limit = kLatticeLimit;
    return static_cast<std::size_t>((std::clamp(v, -limit, limit) + limit) * per_step_);
  }
  /// Visits the squares within the margin of the stroke, and some beside them, until visit(square) returns true.
  template <class Visit>
  bool for_each_square(const Stroke& s, const Visit& visit) const {
    const double low = std::min(s.from.y, s.to.y), high = std::max(s.from.y, s.to.y);
    const std::size_t left = square(std::min(s.from.x, s.to.x) - margin_), top = square(low - margin_);
    const std::size_t right = square(std::max(s.from.x, s.to.x) + margin_), bottom = square(high + margin_);
    if (s.from.x != s.to.x && right - left > 1 && bottom - top > 1) return for_each_crossed(s, left, right, visit);
    for (std::size_t y = top; y <= bottom; ++y) {
      for (std::size_t x = left; x <= right; ++x) {
        if (visit(y * side_ + x)) return true;
      }
    }
    return false;
  }
  /// Visits the squares of a stroke that is not vertical and crosses several columns and rows.
  template <class Visit>
  bool for_each_crossed(const Stroke& s, std::size_t left, std::size_t right, const Visit& visit) const {
    const double low = std::min(s.from.y, s.to.y), high = std::max(s.from.y, s.to.y);
    const double slope = (double(s.to.y) - s.from.y) / (double(s.to.x) - s.from.x);
    const auto y_at = [&](double x) { return std::clamp(s.from.y + (x - s.from.x) * slope, low, high); };
    for (std::size_t x = left; x <= right; ++x) {
      const double x0 = static_cast<double>(x) / per_step_ - kLatticeLimit;
      const double a = y_at(x0 - margin_), b = y_at(x0 + 1 / per_step_ + margin_);
      const std::size_t last = square(std::max(a, b) + margin_);
      for (std::size_t y = square(std::min(a, b) - margin_); y <= last; ++y) {
        if (visit(y * side_ + x)) return true;
      }
    }
    return false;
  }

  std::size_t side_;
  double per_step_ = static_cast<double>(side_) / kPageSteps;
  std::vector<std::uint8_t> marks_;
  double margin_;
};

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
      flagged = flagged || strokes[ends[end].stroke].needs_overlap_check;
    }
    if (flagged && end - begin > 1) {
      for (std::size_t k = begin; k < end; ++k) mark(ends[k].stroke);
    }
    begin = end;
  }
}

/// Returns, in order, the numbers of the strokes that need a check and of the strokes near them.
std::vector<std::uint32_t> find_candidates(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<std::uint32_t> flagged;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].needs_overlap_check && length(strokes[i].from, strokes[i].to) > tolerance_steps) flagged.push_back(i);
  }
  if (flagged.empty() || flagged.size() == strokes.size()) return flagged;
  const MarkedSquares squares(strokes, flagged, tolerance_steps);
  std::vector<std::uint8_t> near(strokes.size(), 0);
  parallel_blocks(strokes.size(), kStrokesPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Stroke& s = strokes[i];
      near[i] = (s.needs_overlap_check || squares.near(s)) && length(s.from, s.to) > tolerance_steps;
    }
  });
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (near[i]) result.push_back(i);
  }
  return result;
}

/// Finds overlaps by the ends of strokes. Two overlapping strokes are of one of these kinds:
/// - One is short, and an end of it lies on the other.
/// - Both strokes and their common interval are long. They have nearly the same direction, and an end of one lies on
///   the other.
/// - Both are long, and their common interval is short. It lies between an end of one and an end of the other.
/// - They share both ends.
/// So the search follows each stroke past the ends of short strokes, and each long stroke also past the ends of long
/// strokes of nearly its direction. From each end of a long stroke it goes a short way past the ends of all long
/// strokes.
class OverlapSearch {
 public:
  OverlapSearch(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& candidates, double tolerance,
                std::vector<OverlapState>& result)
      : strokes_(strokes), tolerance_(tolerance), result_(result) {
    if (stroke_directions::are_crossing(strokes, candidates)) long_ = stroke_directions::kLong * tolerance;
    sort_into_groups(candidates);
  }

  void run() {
    search_along();
    search_near_ends();
  }

  /// Returns whether the stroke was marked before.
  bool mark(std::uint32_t i) {
    return AtomicRef<OverlapState>(result_[i]).exchange(OverlapState::overlapping, std::memory_order_relaxed) ==
           OverlapState::overlapping;
  }

 private:
  using End = EndGrid::End;
  static constexpr std::size_t kShort = stroke_directions::kRanges;  ///< group of the short strokes, after the ranges

  bool is_long(LatticePoint from, LatticePoint to) const { return length(from, to) > long_; }
  std::size_t group_of(LatticePoint from, LatticePoint to) const {
    if (!is_long(from, to)) return kShort;
    return static_cast<std::size_t>(stroke_directions::range_of(stroke_directions::direction(from, to)));
  }
  bool is_overlapping(std::uint32_t i) const {
    return AtomicRef<OverlapState>(result_[i]).load(std::memory_order_relaxed) == OverlapState::overlapping;
  }
  void sort_into_groups(const std::vector<std::uint32_t>& candidates);
  void search_along();
  void search_near_ends();
  LatticePoint stub_of(const End& end) const;
  void search(const End& end, std::size_t group);
  void compare(const End& end, const End& other);
  void settle(const End& end);

  const std::vector<Stroke>& strokes_;
  double tolerance_;
  double long_ = std::numeric_limits<double>::infinity();  ///< longer strokes are sorted by direction
  std::vector<OverlapState>& result_;
  std::array<std::vector<End>, kShort + 1> ends_;  ///< by group
  std::array<EndGrid, kShort + 1> grids_;
};

void OverlapSearch::sort_into_groups(const std::vector<std::uint32_t>& candidates) {
  std::vector<std::uint8_t> group(candidates.size());
  parallel_blocks(candidates.size(), kStrokesPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Stroke& s = strokes_[candidates[k]];
      group[k] = static_cast<std::uint8_t>(group_of(s.from, s.to));
    }
  });
  std::array<std::size_t, kShort + 1> count{};
  for (const std::uint8_t g : group) ++count[g];
  for (std::size_t g = 0; g <= kShort; ++g) ends_[g].reserve(2 * count[g]);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Stroke& s = strokes_[candidates[k]];
    ends_[group[k]].push_back({s.from, s.to, candidates[k]});
    ends_[group[k]].push_back({s.to, s.from, candidates[k]});
  }
}

void OverlapSearch::settle(const End& end) {
  if (mark(end.stroke)) return;
  EndGrid& grid = grids_[group_of(end.p, end.far)];
  grid.settle_end(end.p);
  grid.settle_end(end.far);
}

void OverlapSearch::compare(const End& end, const End& other) {
  if (other.stroke == end.stroke || (is_overlapping(end.stroke) && is_overlapping(other.stroke))) return;
  if (!overlap(end.p, end.far, other.p, other.far, tolerance_)) return;
  if (!strokes_[end.stroke].needs_overlap_check && !strokes_[other.stroke].needs_overlap_check) return;
  settle(end);
  settle(other);
}

/// Follows the stroke of an end of this group past the ends of other strokes.
void OverlapSearch::search(const End& end, std::size_t group) {
  const auto settled = [&] { return is_overlapping(end.stroke); };
  const auto visit = [&](const End& other) { compare(end, other); };
  grids_[kShort].for_each_along(end.p, end.far, tolerance_, settled, visit);
  if (group == kShort) return;
  stroke_directions::for_each_range_near(stroke_directions::direction(end.p, end.far), [&](int range) {
    grids_[static_cast<std::size_t>(range)].for_each_along(end.p, end.far, tolerance_, settled, visit);
  });
}

void OverlapSearch::search_along() {
  // Adjustable: largest ratio of length to width of the cells of a range.
  constexpr double kLongest = 16;
  const double least = kLeastCellInTolerances * tolerance_;
  parallel_tasks(kShort + 1, [&](std::size_t g) {
    const bool is_range = g < kShort;
    const DirectionFrame frame = is_range ? stroke_directions::frame_of(static_cast<int>(g)) : DirectionFrame{};
    grids_[g] = EndGrid(std::move(ends_[g]), {frame, least, is_range ? kLongest : 1, true});
  });
  // A few strokes, spread over the whole page, come first. Among thousands on one line they settle nearly all.
  for (const std::size_t step : {std::size_t{4096}, std::size_t{64}, std::size_t{1}}) {
    for (std::size_t g = 0; g <= kShort; ++g) {
      const std::vector<End>& ends = grids_[g].ends();
      parallel_blocks(block_count(ends.size(), step), kStrokesPerTask, [&](std::size_t begin, std::size_t last) {
        for (std::size_t e = begin; e < last; ++e) {
          if (const End& end = ends[e * step]; end.p < end.far || step > 1) search(end, g);
        }
      });
    }
  }
}

/// Returns the point of the stroke that a short common interval from this end can reach at most.
LatticePoint OverlapSearch::stub_of(const End& end) const {
  const double dx = double(end.far.x) - end.p.x, dy = double(end.far.y) - end.p.y;
  const double part = std::min(1.0, stroke_directions::kLong * tolerance_ / length(end.p, end.far));
  return {end.p.x + static_cast<std::int32_t>(std::lround(part * dx)),
          end.p.y + static_cast<std::int32_t>(std::lround(part * dy))};
}

/// Finds short common intervals of long strokes, between an end of one and an end of the other.
void OverlapSearch::search_near_ends() {
  std::vector<End> long_ends;
  std::size_t count = 0;
  for (std::size_t g = 0; g < kShort; ++g) count += grids_[g].ends().size();
  long_ends.reserve(count);
  for (EndGrid& grid : grids_) {
    if (&grid != &grids_[kShort]) long_ends.insert(long_ends.end(), grid.ends().begin(), grid.ends().end());
    grid = {};
  }
  const double close = EndGrid::reach_of(tolerance_);
  EndGrid grid(std::move(long_ends), {{}, kLeastCellInTolerances * tolerance_, 1, false});
  const std::vector<End>& ends = grid.ends();
  parallel_blocks(ends.size(), kStrokesPerTask, [&](std::size_t begin, std::size_t last) {
    for (std::size_t e = begin; e < last; ++e) {
      const End& end = ends[e];
      if (is_overlapping(end.stroke)) continue;
      const LatticePoint stub = stub_of(end);
      grid.for_each_along(
          end.p, stub, tolerance_, [] { return false; },
          [&](const End& other) {
            if (EndGrid::is_near(end.p, other.p, other.far, close)) compare(end, other);
          });
    }
  });
}

/// Marks each overlapping stroke. The search of a stroke ends at its first overlap.
template <class Mark>
void search_side_by_side(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& candidates, double tolerance,
                         const Mark& mark) {
  const StrokeTree tree(strokes, candidates, tolerance);
  parallel_blocks(candidates.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Stroke& s = strokes[candidates[k]];
      const auto overlaps = [&](std::uint32_t number) {
        const Stroke& other = strokes[candidates[number]];
        return number != k && (s.needs_overlap_check || other.needs_overlap_check) &&
               overlap(s.from, s.to, other.from, other.to, tolerance).has_value();
      };
      if (tree.query(s.from, s.to, overlaps)) mark(candidates[k]);
    }
  });
}

}  // namespace

std::vector<OverlapState> find_overlapping_strokes(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<OverlapState> result(strokes.size(), OverlapState::excluded);
  const std::vector<std::uint32_t> candidates = find_candidates(strokes, tolerance_steps);
  if (candidates.empty()) return result;
  for (const std::uint32_t i : candidates) {
    if (strokes[i].needs_overlap_check) result[i] = OverlapState::alone;
  }
  if (StrokeTree::suits(strokes, candidates, tolerance_steps)) {
    search_side_by_side(strokes, candidates, tolerance_steps,
                        [&](std::uint32_t i) { result[i] = OverlapState::overlapping; });
    return result;
  }
  OverlapSearch search(strokes, candidates, tolerance_steps, result);
  search.run();
  mark_same_ends(strokes, candidates, [&](std::uint32_t i) { search.mark(i); });
  return result;
}

std::vector<std::uint32_t> strokes_that_overlap(const std::vector<Stroke>& others, const std::vector<Stroke>& strokes,
                                                const std::vector<std::uint32_t>& of, double tolerance_steps) {
  std::vector<std::uint32_t> all(others.size());
  std::iota(all.begin(), all.end(), 0u);
  const MarkedSquares squares(others, all, tolerance_steps);
  StrokeIndex index(index_cell(others, all, tolerance_steps), tolerance_steps);
  for (const Stroke& s : others) index.insert(s.from, s.to);
  std::vector<std::uint8_t> has(of.size(), 0);
  parallel_blocks(of.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Stroke& s = strokes[of[k]];
      if (!squares.near(s)) continue;
      has[k] = index.query(s.from, s.to, [&](std::uint32_t i) {
        return overlap(s.from, s.to, others[i].from, others[i].to, tolerance_steps).has_value();
      });
    }
  });
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < of.size(); ++k) {
    if (has[k]) found.push_back(of[k]);
  }
  return found;
}

}  // namespace ligne
