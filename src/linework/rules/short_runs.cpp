/// Rules for runs and chains that are too short to be seen as lines of their own.

#include <vector>

#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"

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
  const Chains chains(map);
  std::size_t removed = 0;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (!map.is_alive(p)) continue;
    const Chains::Chain& chain = chains[chains.of(p)];
    if (!chain.only_edges || chain.length >= least_mm / map.step_mm() || chain.free_ends != 2) continue;
    if (chain.cut_ends == 0 && !chain.only_intersections) continue;
    removed += chains.of(p) == p;
    map.remove(p);
  }
  return removed;
}

}  // namespace ligne
