#include <vector>

#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Returns the fraction of a piece that no part covers. Unites the parts.
double uncovered(std::vector<StrokePart>& parts) {
  unite(parts);
  double covered = 0;
  for (const StrokePart& part : parts) covered += part.to - part.from;
  return 1 - covered;
}

}  // namespace

std::size_t remove_overdrawn_runs(LineMap& map, const OverdrawLimits& limits) {
  const double step = map.step_mm(), ink = limits.ink_mm / step;
  const Runs runs(map);
  const auto is_short = [&](std::uint32_t p) { return runs[runs.of(p)].length < limits.longest_mm / step; };
  std::vector<double> shown(map.piece_count(), 0);          // by run
  std::vector<std::uint8_t> touches(map.piece_count(), 0);  // by run: whether it meets the ink of another line
  // By run: whether a stroke of the model is part of it. A run that only joins lines stays, since it would be made again.
  std::vector<std::uint8_t> is_given(map.piece_count(), 0);
  std::vector<std::uint32_t> bits;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (runs.of(p) == kNone || !is_short(p)) continue;
    bits.push_back(p);
    const Stroke& bit = map.piece(p);
    std::vector<StrokePart> covered;
    map.near(bit.from, bit.to, ink, [&](std::uint32_t other) {
      if (runs.of(other) == kNone || is_short(other)) return false;
      const StrokePart part = part_near(bit, map.piece(other), ink);
      if (!part.empty()) covered.push_back(part);
      return part.from == 0 && part.to == 1;
    });
    is_given[runs.of(p)] |= !bit.is_joint;
    touches[runs.of(p)] |= !covered.empty();
    shown[runs.of(p)] += uncovered(covered) * page_length(bit);
  }
  std::size_t removed = 0;
  for (const std::uint32_t b : bits) {
    const std::uint32_t run = runs.of(b);
    if (!is_given[run] || !touches[run] || shown[run] >= limits.shown_mm / step) continue;
    removed += run == b;
    map.remove(b);
  }
  return removed;
}

}  // namespace ligne
