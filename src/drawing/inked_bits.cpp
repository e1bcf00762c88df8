#include "drawing/inked_bits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drawing/key_table.hpp"
#include "drawing/near_part.hpp"
#include "drawing/stroke_chains.hpp"
#include "drawing/stroke_index.hpp"
#include "drawing/stroke_lines.hpp"
#include "geometry/disjoint_sets.hpp"

namespace ligne {
namespace {

/// The run that gives a short run its class: over runs that are longer and longer, the first that is not short itself or has
/// no longer one beside it.
std::uint32_t giver(const StrokeLines& lines, std::uint32_t run, double least) {
  while (lines.run(run).length < least) {
    const std::uint32_t beside = lines.run(run).longest_beside;
    if (beside == StrokeLines::kNone || lines.run(beside).line_class == LineClass::mesh ||
        lines.run(beside).length <= lines.run(run).length) {
      break;
    }
    run = beside;
  }
  return run;
}

/// Of the whole, what no part covers.
double uncovered(std::vector<StrokePart>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const StrokePart& a, const StrokePart& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
  double open = 0, covered_to = 0;
  for (const StrokePart& part : parts) {
    open += std::max(0.0, part.from - covered_to);
    covered_to = std::max(covered_to, part.to);
  }
  return open + std::max(0.0, 1 - covered_to);
}

/// Runs of bits, by their lowest strokes, in groups: where one ends another ends, within `reach`.
DisjointSets touching_runs(const std::vector<Stroke>& strokes, const StrokeLines& lines,
                           const std::vector<std::uint32_t>& bits, const SegmentGrid& grid, double reach) {
  DisjointSets groups(strokes.size());
  KeyTable cells;                                              // of each cell the first link
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // end, next link
  const auto point = [&](std::uint32_t end) {
    return end % 2 == 0 ? strokes[bits[end / 2]].from : strokes[bits[end / 2]].to;
  };
  for (std::uint32_t end = 0; end < 2 * bits.size(); ++end) {
    const LatticePoint p = point(end);
    grid.walk(p, p, [&](std::uint64_t cell) {
      for (std::uint32_t l = cells.find(cell); l != KeyTable::kNone; l = links[l].second) {
        const LatticePoint q = point(links[l].first);
        if (std::hypot(double(q.x) - p.x, double(q.y) - p.y) > reach) continue;
        groups.join(lines.chain_of(bits[end / 2]), lines.chain_of(bits[links[l].first / 2]));
      }
      return false;
    });
    std::uint32_t& first = cells[grid.cell_of(p)];
    links.emplace_back(end, first);
    first = static_cast<std::uint32_t>(links.size() - 1);
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
    const std::uint32_t from = giver(lines, run, least);
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

  const SegmentGrid grid(2 * reach, reach);
  KeyTable cells;                                              // of each cell the first link
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // bit, next link
  for (std::uint32_t b = 0; b < bits.size(); ++b) {
    grid.walk(strokes[bits[b]].from, strokes[bits[b]].to, [&](std::uint64_t cell) {
      std::uint32_t& first = cells[cell];
      links.emplace_back(b, first);
      first = static_cast<std::uint32_t>(links.size() - 1);
      return false;
    });
  }
  std::vector<std::vector<StrokePart>> covered(bits.size());
  for (const std::uint32_t i : lines.seen()) {
    if (is_short(i)) continue;
    grid.walk(strokes[i].from, strokes[i].to, [&](std::uint64_t cell) {
      for (std::uint32_t l = cells.find(cell); l != KeyTable::kNone; l = links[l].second) {
        const std::uint32_t b = links[l].first;
        const StrokePart part = part_near(strokes[bits[b]], strokes[i], reach);
        if (!part.empty()) covered[b].push_back(part);
      }
      return false;
    });
  }
  DisjointSets groups = touching_runs(strokes, lines, bits, grid, reach);
  std::vector<double> shown(strokes.size(), 0);          // by group
  std::vector<std::uint8_t> touches(strokes.size(), 0);  // by group: the ink of another line
  for (std::uint32_t b = 0; b < bits.size(); ++b) {
    const std::uint32_t group = groups.find(lines.chain_of(bits[b]));
    touches[group] |= !covered[b].empty();
    shown[group] += uncovered(covered[b]) * page_length(strokes[bits[b]]);
  }
  return leave_out(strokes, lines, [&](std::uint32_t run) {
    const std::uint32_t group = groups.find(run);
    return lines.run(run).length < limits.longest_mm / step && touches[group] && shown[group] < limits.shown_mm / step;
  });
}

}  // namespace ligne
