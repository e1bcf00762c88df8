#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/near_part.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// The parts of a piece in the ink of other lines. Parts are merged as they are added, so that a piece among thousands
/// of lines stores few.
class CoveredIntervals {
 public:
  void add(const StrokePart& part) {
    parts_.push_back(part);
    if (parts_.size() >= most_ || (part.from == 0 && part.to == 1)) unite_parts();
  }
  bool empty() const { return parts_.empty(); }
  bool is_whole() const { return parts_.size() == 1 && parts_[0].from == 0 && parts_[0].to == 1; }

  /// Returns the fraction of the piece that no part covers.
  double uncovered() {
    unite_parts();
    double open = 0, covered_to = 0;
    for (const StrokePart& part : parts_) {
      open += part.from - covered_to;
      covered_to = part.to;
    }
    return open + (1 - covered_to);
  }

 private:
  void unite_parts() {
    unite(parts_);
    most_ = 2 * parts_.size() + 6;
  }

  std::vector<StrokePart> parts_;
  std::size_t most_ = 8;
};

/// Groups runs of the short pieces `bits`: two runs belong together if an end of one is within `reach` of an end of the
/// other. Runs are known by their lowest pieces. Any two ends in one grid cell are that near; ends of two cells are
/// compared until the first pair is found. O(n log n) unless cells with many ends touch.
DisjointSets touching_runs(const LineMap& map, const Runs& runs, const std::vector<std::uint32_t>& bits, double reach) {
  struct End {
    std::int32_t column, row;
    LatticePoint p;
    std::uint32_t run;
  };
  constexpr int kReachInCells = 2;
  const double cell = std::max(1.0, reach / std::numbers::sqrt2);
  const auto index = [&](double v) { return static_cast<std::int32_t>(std::floor(v / cell)); };
  std::vector<End> ends;
  for (const std::uint32_t b : bits) {
    for (const LatticePoint p : {map.piece(b).from, map.piece(b).to})
      ends.push_back({index(p.x), index(p.y), p, runs.of(b)});
  }
  const auto key = [](const End& e) { return std::pair(e.column, e.row); };
  std::ranges::sort(ends, {}, key);
  DisjointSets groups(map.piece_count());
  const auto join_cells = [&](std::span<const End> of, std::span<const End> others) {
    if (groups.find(of[0].run) == groups.find(others[0].run)) return;
    for (const End& a : of) {
      for (const End& b : others) {
        if (length(a.p, b.p) <= reach) return groups.join(a.run, b.run);
      }
    }
  };
  const auto cell_at = [&](std::int32_t column, std::int32_t row) {
    const std::pair at(column, row);
    const auto first = std::ranges::lower_bound(ends, at, {}, key);
    return std::span<const End>(first, std::ranges::upper_bound(first, ends.end(), at, {}, key));
  };
  for (std::size_t begin = 0; begin < ends.size();) {
    const auto [column, row] = key(ends[begin]);
    const std::span<const End> of = cell_at(column, row);
    for (const End& e : of) groups.join(e.run, of[0].run);
    // Joins with the cells around it that come before it in order.
    for (std::int32_t c = column - kReachInCells; c <= column; ++c) {
      for (std::int32_t r = row - kReachInCells; r <= row + kReachInCells && (c < column || r < row); ++r) {
        if (const std::span<const End> others = cell_at(c, r); !others.empty()) join_cells(of, others);
      }
    }
    begin += of.size();
  }
  return groups;
}

}  // namespace

std::size_t remove_overdrawn_runs(LineMap& map, const OverdrawLimits& limits) {
  const double step = map.step_mm(), ink = limits.ink_mm / step;
  const Runs runs(map);
  const auto is_short = [&](std::uint32_t p) { return runs[runs.of(p)].length < limits.longest_mm / step; };
  std::vector<std::uint32_t> bits;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (runs.of(p) != kNone && is_short(p)) bits.push_back(p);
  }
  if (bits.empty()) return 0;
  DisjointSets groups = touching_runs(map, runs, bits, ink);
  std::vector<double> shown(map.piece_count(), 0);          // by group
  std::vector<std::uint8_t> touches(map.piece_count(), 0);  // by group: whether it meets the ink of another line
  for (const std::uint32_t b : bits) {
    const Stroke& bit = map.piece(b);
    CoveredIntervals covered;
    map.near(bit.from, bit.to, ink, [&](std::uint32_t p) {
      if (runs.of(p) == kNone || is_short(p)) return false;
      if (const StrokePart part = part_near(bit, map.piece(p), ink); !part.empty()) covered.add(part);
      return covered.is_whole();
    });
    const std::uint32_t group = groups.find(runs.of(b));
    touches[group] |= !covered.empty();
    shown[group] += covered.uncovered() * page_length(bit);
  }
  std::size_t removed = 0;
  for (const std::uint32_t b : bits) {
    const std::uint32_t group = groups.find(runs.of(b));
    if (!touches[group] || shown[group] >= limits.shown_mm / step) continue;
    removed += runs.of(b) == b;
    map.remove(b);
  }
  return removed;
}

}  // namespace ligne
