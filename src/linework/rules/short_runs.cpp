/// Rules for runs and chains that are too short to be seen as lines of their own.

#include <algorithm>

#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Returns the run whose class a short run takes. Follows the longest neighbour until a run is long enough or has no
/// longer neighbour.
std::uint32_t class_donor(const Runs& runs, std::uint32_t run, double least) {
  while (runs[run].length < least) {
    const std::uint32_t beside = runs[run].longest_beside;
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
  const auto is_short = [&](const Arcs::Arc& chain) { return chain.length < least_mm / map.step_mm(); };
  const auto is_loose = [&](const Arcs::Arc& chain) {
    return chain.junctions.size() == 2 && map.is_free(chain.ends.front()) && map.is_free(chain.ends.back() ^ 1);
  };
  const auto is_cut = [&](std::uint32_t end) {
    return end % 2 == 0 ? map.piece(end / 2).t_from > 0 : map.piece(end / 2).t_to < 1;
  };
  const auto all = [&](const Arcs::Arc& chain, const auto& holds) {
    return std::ranges::all_of(chain.pieces, [&](std::uint32_t p) { return holds(map.piece(p)); });
  };
  const auto is_intersection = [](const Stroke& s) { return s.line_class == LineClass::intersection; };
  std::size_t removed = 0;
  for (const Arcs::Arc& chain : Arcs(map, Arcs::kNoContacts).find()) {
    if (!is_short(chain) || !is_loose(chain) || !all(chain, is_edge)) continue;
    if (!is_cut(chain.ends.front()) && !is_cut(chain.ends.back() ^ 1) && !all(chain, is_intersection)) continue;
    for (const std::uint32_t p : chain.pieces) map.remove(p);
    ++removed;
  }
  return removed;
}

}  // namespace ligne
