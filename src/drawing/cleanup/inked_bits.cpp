#include "drawing/cleanup/inked_bits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/graphs/stroke_lines.hpp"
#include "drawing/near_part.hpp"
#include "drawing/overlaps/stroke_index.hpp"

namespace ligne {
namespace {

/// The run whose class a short run takes. Follows the longest neighbour until a run is long enough or has no longer
/// neighbour.
std::uint32_t class_donor(const StrokeLines& lines, std::uint32_t run, double least) {
  while (lines.run(run).length < least) {
    const std::uint32_t beside = lines.run(run).longest_beside;
    if (beside == kNone || lines.run(beside).line_class == LineClass::mesh ||
        lines.run(beside).length <= lines.run(run).length) {
      break;
    }
    run = beside;
  }
  return run;
}

/// The parts of a bit in the ink of other lines. Parts are united as they come: a bit among thousands of lines keeps few.
class Inked {
 public:
  void add(const StrokePart& part) {
    parts_.push_back(part);
    if (parts_.size() >= most_ || (part.from == 0 && part.to == 1)) unite();
  }
  bool empty() const { return parts_.empty(); }
  bool is_whole() const { return parts_.size() == 1 && parts_[0].from == 0 && parts_[0].to == 1; }

  /// The length of the whole that no part covers.
  double uncovered() {
    unite();
    double open = 0, covered_to = 0;
    for (const StrokePart& part : parts_) {
      open += part.from - covered_to;
      covered_to = part.to;
    }
    return open + (1 - covered_to);
  }

 private:
  void unite() {
    std::sort(parts_.begin(), parts_.end(), [](const StrokePart& a, const StrokePart& b) { return a.from < b.from; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      if (parts_[i].from <= parts_[last].to) {
        parts_[last].to = std::max(parts_[last].to, parts_[i].to);
      } else {
        parts_[++last] = parts_[i];
      }
    }
    if (!parts_.empty()) parts_.resize(last + 1);
    most_ = 2 * parts_.size() + 6;
  }

  std::vector<StrokePart> parts_;
  std::size_t most_ = 8;
};

/// The ink on each bit, by the lines that are no bits. A bit that is whole is looked at no more: so where the pen is wide
/// against the lines the cost follows the bits and not their pairs with lines.
std::vector<Inked> ink_bits(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& bits,
                            const std::vector<std::uint32_t>& lines, const SegmentGrid& grid, double reach) {
  KeyTable cells;                                              // of each cell a link that stands before its first
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // bit, next link
  for (std::uint32_t b = 0; b < bits.size(); ++b) {
    grid.walk(strokes[bits[b]].from, strokes[bits[b]].to, [&](std::uint64_t cell) {
      std::uint32_t& head = cells[cell];
      if (head == kNone) {
        head = static_cast<std::uint32_t>(links.size());
        links.emplace_back(kNone, kNone);
      }
      links.emplace_back(b, links[head].second);
      links[head].second = static_cast<std::uint32_t>(links.size() - 1);
      return false;
    });
  }
  std::vector<Inked> inked(bits.size());
  for (const std::uint32_t i : lines) {
    grid.walk(strokes[i].from, strokes[i].to, [&](std::uint64_t cell) {
      std::uint32_t before = cells.find(cell);
      if (before == kNone) return false;
      for (std::uint32_t l = links[before].second; l != kNone; l = links[l].second) {
        const std::uint32_t b = links[l].first;
        if (inked[b].is_whole()) {
          links[before].second = links[l].second;
          continue;
        }
        before = l;
        const StrokePart part = part_near(strokes[bits[b]], strokes[i], reach);
        if (!part.empty()) inked[b].add(part);
      }
      return false;
    });
  }
  return inked;
}

/// Runs of bits, by their lowest strokes, in groups: where one ends another ends, within `reach`. Ends in one cell are that
/// near; of two cells the ends are compared until the first pair is found. O(n log n) where cells of many ends touch.
DisjointSets touching_runs(const std::vector<Stroke>& strokes, const StrokeLines& lines,
                           const std::vector<std::uint32_t>& bits, double reach) {
  struct End {
    std::int32_t column, row;
    LatticePoint p;
    std::uint32_t run;
  };
  constexpr int kReachInCells = 2;
  const double cell = std::max(1.0, reach / std::numbers::sqrt2);
  const auto index = [&](double v) { return static_cast<std::int32_t>(std::floor(v / cell)); };
  std::vector<End> ends;
  for (const std::uint32_t i : bits) {
    for (const LatticePoint p : {strokes[i].from, strokes[i].to}) {
      ends.push_back({index(p.x), index(p.y), p, lines.chain_of(i)});
    }
  }
  const auto key = [](const End& e) { return std::pair(e.column, e.row); };
  std::ranges::sort(ends, {}, key);
  DisjointSets groups(strokes.size());
  const auto join_cells = [&](std::span<const End> of, std::span<const End> others) {
    if (groups.find(of[0].run) == groups.find(others[0].run)) return;
    for (const End& a : of) {
      for (const End& b : others) {
        if (std::hypot(double(a.p.x) - b.p.x, double(a.p.y) - b.p.y) <= reach) return groups.join(a.run, b.run);
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
    // Those of the cells round it that come before it in order.
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

std::size_t join_short_classes(StrokeModel& model, double least_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  const double least = least_mm / model.lattice.step_mm;
  const StrokeLines lines(strokes);
  std::size_t joined = 0;
  for (const std::uint32_t i : lines.seen()) {
    const std::uint32_t run = lines.chain_of(i);
    if (lines.run(run).line_class == LineClass::mesh) continue;
    const std::uint32_t from = class_donor(lines, run, least);
    if (from == run) continue;
    joined += run == i;
    strokes[i].line_class = lines.run(from).line_class;
  }
  return joined;
}

std::size_t drop_inked_bits(StrokeModel& model, const InkLimits& limits) {
  std::vector<Stroke>& strokes = model.strokes;
  const double step = model.lattice.step_mm, reach = limits.ink_mm / step;
  const StrokeLines lines(strokes);
  const auto is_short = [&](std::uint32_t i) { return lines.run(lines.chain_of(i)).length < limits.longest_mm / step; };
  std::vector<std::uint32_t> bits;
  for (const std::uint32_t i : lines.seen()) {
    if (is_short(i)) bits.push_back(i);
  }
  if (bits.empty()) return 0;

  std::vector<std::uint32_t> long_lines;
  for (const std::uint32_t i : lines.seen()) {
    if (!is_short(i)) long_lines.push_back(i);
  }
  const SegmentGrid grid(walked_cell(strokes, 2 * reach), reach);
  std::vector<Inked> inked = ink_bits(strokes, bits, long_lines, grid, reach);
  DisjointSets groups = touching_runs(strokes, lines, bits, reach);
  std::vector<double> shown(strokes.size(), 0);          // by group
  std::vector<std::uint8_t> touches(strokes.size(), 0);  // by group: the ink of another line
  for (std::uint32_t b = 0; b < bits.size(); ++b) {
    const std::uint32_t group = groups.find(lines.chain_of(bits[b]));
    touches[group] |= !inked[b].empty();
    shown[group] += inked[b].uncovered() * page_length(strokes[bits[b]]);
  }
  return leave_out(strokes, lines, [&](std::uint32_t run) {
    const std::uint32_t group = groups.find(run);
    return lines.run(run).length < limits.longest_mm / step && touches[group] && shown[group] < limits.shown_mm / step;
  });
}

}  // namespace ligne
