#include "linework/clean_lines.hpp"

#include <algorithm>
#include <array>

#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

// Lengths in pen widths or in gaps (gap_mm()). "Taste" marks values that were chosen by looking at drawings.
constexpr double kGapInPens = 1;                               ///< a wider gap shows between the round ends of two lines
constexpr double kWideInGaps = 3;                              ///< widest gap that is bridged without outlines: taste
constexpr double kFarInGaps = 12;                              ///< widest gap that is bridged with outlines: taste
constexpr double kLineReachInPens = 0.5;                       ///< ink of a line reaches half a pen to either side
constexpr double kShownInPens = 0.5;                           ///< least length that shows outside of other ink: taste
constexpr double kMeetingInPens = 1;                           ///< lines this near to each other touch
constexpr double kTouchingInPens = 1.0 / 16;                   ///< an end this near lies on a line; allows for rounding
constexpr double kUndershootInGaps = 3;                        ///< longest extension of an end: taste
constexpr double kDangleInPens = 12, kDanglePart = 1.0 / 32;   ///< longest dangle, also as part of its body: taste
constexpr double kBesideInPens = 2.5, kBesideInDangles = 4;    ///< arcs beside a line, largest distance and size: taste
constexpr double kMaxScanIsolatedInPens = 8, kLoneInPens = 5;  ///< longest isolated chains: taste
constexpr double kMaxIsolatedPart = 1.0 / 48;                  ///< also as part of the extent of the body: taste
constexpr double kRingInPens = 0.25;                           ///< a ring no wider than this is drawn as one line

double gap_mm(const CleanOptions& o) { return std::min(o.least_mm, kGapInPens * o.pen_mm); }

std::size_t apply_bridge_gaps(LineMap& map, const CleanOptions& o) {
  const double widest = (o.has_outlines ? kFarInGaps : kWideInGaps) * gap_mm(o);
  return bridge_gaps(map, {gap_mm(o), widest, kLineReachInPens * o.pen_mm}, o.make_source);
}

std::size_t apply_prune_dangles(LineMap& map, const CleanOptions& o) {
  if (!o.scan_of) return 0;
  return prune_dangles(map, o.scan_of,
                       {.longest_mm = kDangleInPens * o.pen_mm,
                        .body_part = kDanglePart,
                        .beside_mm = kBesideInPens * o.pen_mm,
                        .beside_times = kBesideInDangles,
                        .touching_mm = kMeetingInPens * o.pen_mm});
}

std::size_t apply_bridge_after_pruning(LineMap& map, const CleanOptions& o) {
  return o.scan_of ? apply_bridge_gaps(map, o) : 0;
}

std::size_t apply_merge_short_runs(LineMap& map, const CleanOptions& o) { return merge_short_runs(map, o.least_mm); }

std::size_t apply_remove_short_bits(LineMap& map, const CleanOptions& o) { return remove_short_bits(map, o.least_mm); }

std::size_t apply_remove_overdrawn_runs(LineMap& map, const CleanOptions& o) {
  return remove_overdrawn_runs(map, {o.least_mm, kLineReachInPens * o.pen_mm, kShownInPens * o.pen_mm});
}

std::size_t remove_isolated(LineMap& map, const CleanOptions& o, const BodyOf& body_of, double longest_in_pens) {
  return remove_isolated_chains(
      map, body_of,
      {.longest_mm = longest_in_pens * o.pen_mm, .body_part = kMaxIsolatedPart, .ring_width_mm = kRingInPens * o.pen_mm});
}

std::size_t apply_remove_isolated_of_scans(LineMap& map, const CleanOptions& o) {
  return o.scan_of ? remove_isolated(map, o, o.scan_of, kMaxScanIsolatedInPens) : 0;
}

std::size_t apply_remove_isolated_chains(LineMap& map, const CleanOptions& o) {
  return o.has_all_features ? remove_isolated(map, o, o.object_of, kLoneInPens) : 0;
}

std::size_t apply_extend_undershoots(LineMap& map, const CleanOptions& o) {
  if (!o.has_outlines) return 0;
  return extend_undershoots(map, {kUndershootInGaps * gap_mm(o), kTouchingInPens * o.pen_mm}, o.make_source);
}

constexpr std::array kRules{
    CleaningRule{"bridge_gaps", "gaps bridged", apply_bridge_gaps},
    CleaningRule{"prune_dangles", "dangles of scans removed", apply_prune_dangles},
    CleaningRule{"bridge_gaps", "gaps bridged without dangles", apply_bridge_after_pruning},
    CleaningRule{"merge_short_runs", "short runs in the class of their line", apply_merge_short_runs},
    CleaningRule{"remove_short_bits", "short bits removed", apply_remove_short_bits},
    CleaningRule{"remove_overdrawn_runs", "short runs in the ink of other lines", apply_remove_overdrawn_runs},
    CleaningRule{"remove_isolated_chains", "isolated chains of scans removed", apply_remove_isolated_of_scans},
    CleaningRule{"remove_isolated_chains", "isolated chains removed", apply_remove_isolated_chains},
    CleaningRule{"extend_undershoots", "ends led to the line before them", apply_extend_undershoots},
};

}  // namespace

std::span<const CleaningRule> cleaning_rules() { return kRules; }

CleanReport clean_lines(StrokeModel& model, const CleanOptions& options) {
  CleanReport report;
  for (const CleaningRule& rule : kRules) report.rules.push_back({rule.name, rule.changes});
  const double step = model.lattice.step_mm, reach = kMeetingInPens * options.pen_mm / step;
  /// Side of the cells in which rules look for lines, in pen widths. Adjustable.
  constexpr double kCellInPens = 4;
  const double cell = walked_cell(model.strokes, kCellInPens * options.pen_mm / step);
  bool is_clean = false;
  while (!is_clean && report.passes < kMostCleanPasses) {
    ++report.passes;
    is_clean = true;
    LineMap map(
        model, [](const Stroke& s) { return s.line_class != LineClass::mesh; }, {.reach = reach}, cell);
    for (std::size_t r = 0; r < kRules.size(); ++r) {
      const double added = map.added_steps(), removed = map.removed_steps();
      const std::size_t count = kRules[r].apply(map, options);
      if (count == 0) continue;
      is_clean = false;
      report.rules[r].count += count;
      report.rules[r].added_mm += (map.added_steps() - added) * step;
      report.rules[r].removed_mm += (map.removed_steps() - removed) * step;
    }
    if (!is_clean) map.commit(kLineReachInPens * options.pen_mm / step);
  }
  return report;
}

}  // namespace ligne
