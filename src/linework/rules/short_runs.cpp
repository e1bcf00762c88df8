/// Rules for runs and chains that are too short to be seen as lines of their own, or lie in the ink of others.

#include <algorithm>
#include <vector>

#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Returns the run whose class a short run takes. Follows the longest neighbour until a run is long enough or has no
/// longer neighbour.
std::uint32_t class_donor(const Runs& runs, std::uint32_t run, double least) {
  while (runs[run].length < least) {
    const std::uint32_t beside = runs[run].longest_continuation;
    if (beside == kNone || runs[beside].line_class == LineClass::mesh || runs[beside].length <= runs[run].length) break;
    run = beside;
  }
  return run;
}

}  // namespace

std::size_t merge_short_runs(LineMap& map, double least_mm) {
  const Runs runs(map);
  std::size_t merged = 0;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    const std::uint32_t run = runs.of(p);
    if (run == kNone || runs[run].line_class == LineClass::mesh) continue;
    const std::uint32_t donor = class_donor(runs, run, least_mm / map.step_mm());
    if (donor == run) continue;
    merged += run == p;
    map.set_class(p, runs[donor].line_class);
  }
  return merged;
}

std::size_t remove_short_bits(LineMap& map, double least_mm) {
  const double least = least_mm / map.step_mm();
  const auto is_cut = [&](std::uint32_t end) {
    return end % 2 == 0 ? map.piece(end / 2).t_from > 0 : map.piece(end / 2).t_to < 1;
  };
  const auto all = [&](const Arcs::Arc& chain, const auto& holds) {
    return std::ranges::all_of(chain.pieces, [&](std::uint32_t p) { return holds(map.piece(p)); });
  };
  const auto is_intersection = [](const Stroke& s) { return s.line_class == LineClass::intersection; };
  std::size_t removed = 0;
  for (std::uint32_t end = 0; end < 2 * map.piece_count(); ++end) {
    if (!map.is_alive(end / 2) || !map.is_free(end)) continue;
    const Arcs::Arc chain = chain_from(map, end, least);
    if (chain.ends.empty() || chain.length >= least) continue;
    const std::uint32_t far = chain.ends.back() ^ 1;
    if (!map.is_free(far) || !all(chain, is_edge)) continue;
    if (!is_cut(end) && !is_cut(far) && !all(chain, is_intersection)) continue;
    for (const std::uint32_t p : chain.pieces) map.remove(p);
    ++removed;
  }
  return removed;
}

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
    unite(covered);
    double hidden = 0;  // as a fraction
    for (const StrokePart& part : covered) hidden += part.to - part.from;
    shown[runs.of(p)] += (1 - hidden) * page_length(bit);
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
