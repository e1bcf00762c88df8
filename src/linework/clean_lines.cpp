#include "linework/clean_lines.hpp"

#include <algorithm>
#include <optional>

namespace ligne {
namespace {

// Lengths in pen widths or in gaps (gap_mm()). "Taste" marks values that were chosen by looking at drawings.
constexpr double kGapInPens = 1;                                ///< a wider gap shows between the round ends of two lines
constexpr double kWideInGaps = 3;                               ///< widest gap that is bridged without outlines: taste
constexpr double kFarInGaps = 12;                               ///< widest gap that is bridged with outlines: taste
constexpr double kLineReachInPens = 0.5;                        ///< ink of a line reaches half a pen to either side
constexpr double kShownInPens = 0.5;                            ///< least length that shows outside of other ink: taste
constexpr double kMeetingInPens = 1;                            ///< lines this near to each other touch
constexpr double kTouchingInPens = 1.0 / 16;                    ///< an end this near lies on a line; allows for rounding
constexpr double kUndershootInGaps = 6;                         ///< longest extension of an end: taste
constexpr double kOvershootInPens = 12;                         ///< longest end behind a crossing that is cut: taste
constexpr double kDangleInPens = 12, kDanglePart = 1.0 / 32;    ///< longest dangle, also as part of its body: taste
constexpr double kBesideInPens = 2.5, kBesideInDangles = 4;     ///< arcs beside a line, largest distance and size: taste
constexpr double kMaxScanIsolatedInPens = 12, kLoneInPens = 5;  ///< longest isolated chains: taste
constexpr double kMaxIsolatedPart = 1.0 / 48;                   ///< also as part of the extent of the body: taste
/// An isolated line that is straight may be so many times as long on scans: a triangle that stands out has one such edge in
/// sight. Taste.
constexpr double kScanStraightTimes = 2;
/// How many times as long dangles and isolated chains of decimated parts may be that consist of kFoldEdges edges or fewer.
/// Dangles reach an eighth of their part then, as loose creases do, and isolated chains a twelfth: longer creases are lines.
constexpr double kDecimatedTimes = 4;
/// Largest number of edges of the outline at a fold that decimation makes: those of one triangle that face the viewer.
constexpr std::size_t kFoldEdges = 2;
/// Longest dangle of the outline of a mesh of a free form, and its longest isolated chain, in facets: a fold turns over two
/// edges or more, so that the mesh tells nothing of shorter ones. No larger in pen widths: taste.
constexpr double kDangleInFacets = 2, kFormDangleInPens = 36, kIsolatedInFacets = 1;
constexpr double kRingInPens = 0.5;  ///< a ring is drawn as one line where it lies this near to its axis: ink fills it

double gap_mm(const CleanOptions& o) { return std::min(o.least_mm, kGapInPens * o.pen_mm); }

/// Limits of isolated chains. `times`: how many times as long they may be where they are folds, or 1 for all.
IsolatedLimits isolated_limits(double pen_mm, double longest_in_pens, double straight_times, double times = 1) {
  return {.longest_mm = times * longest_in_pens * pen_mm,
          .body_part = times * kMaxIsolatedPart,
          .ring_width_mm = kRingInPens * pen_mm,
          .straight_times = straight_times,
          .most_sources = times > 1 ? kFoldEdges : kAnySources};
}

/// Limits of the dangles of scans. `times`: as for isolated chains.
DangleLimits dangle_limits(double pen_mm, double times) {
  return {.longest_mm = times * kDangleInPens * pen_mm,
          .body_part = times * kDanglePart,
          .beside_mm = kBesideInPens * pen_mm,
          .beside_times = kBesideInDangles / times,
          .touching_mm = kMeetingInPens * pen_mm,
          .most_sources = times > 1 ? kFoldEdges : kAnySources};
}

/// Applies the rules once, in their order. Calls report(what the rule does, number of its changes) for each.
/// `has_closed_gaps`: whether a pass came before. Outlines between contours are dangles until their gaps are closed.
template <class Report>
void apply_rules(LineMap& map, const CleanOptions& o, bool has_closed_gaps, const Report& report) {
  const double pen_mm = o.pen_mm, ink_mm = kLineReachInPens * pen_mm;
  const GapLimits gaps{gap_mm(o), (o.has_outlines ? kFarInGaps : kWideInGaps) * gap_mm(o), ink_mm};
  report("gaps bridged", bridge_gaps(map, gaps, o.make_source));
  if (o.scan_of) {
    report("dangles of scans removed", prune_dangles(map, o.scan_of, dangle_limits(pen_mm, 1)));
    // Outlines that end at a gap are dangles until it is closed.
    if (has_closed_gaps && o.decimated_of)
      report("dangles of scans removed", prune_dangles(map, o.decimated_of, dangle_limits(pen_mm, kDecimatedTimes)));
    report("gaps bridged without dangles", bridge_gaps(map, gaps, o.make_source));
  }
  if (has_closed_gaps && o.form_of) {
    const DangleLimits dangles{.longest_mm = kFormDangleInPens * pen_mm,
                               .body_part = kDangleInFacets,
                               .beside_mm = kMeetingInPens * pen_mm,
                               .touching_mm = kMeetingInPens * pen_mm,
                               .factors = o.facet_parts};
    report("dangles of free forms removed", prune_dangles(map, o.form_of, dangles));
  }
  report("short runs in the class of their line", merge_short_runs(map, o.least_mm));
  report("short bits removed", remove_short_bits(map, o.least_mm));
  report("short runs in the ink of other lines", remove_overdrawn_runs(map, {o.least_mm, ink_mm, kShownInPens * pen_mm}));
  if (o.scan_of) {
    report("isolated chains of scans removed",
           remove_isolated_chains(map, o.scan_of, isolated_limits(pen_mm, kMaxScanIsolatedInPens, kScanStraightTimes)));
  }
  if (has_closed_gaps && o.decimated_of) {
    report("isolated chains of scans removed",
           remove_isolated_chains(map, o.decimated_of, isolated_limits(pen_mm, kMaxScanIsolatedInPens, 1, kDecimatedTimes)));
  }
  if (has_closed_gaps && o.has_all_features && o.form_of) {
    IsolatedLimits limits = isolated_limits(pen_mm, kMaxScanIsolatedInPens, 1);
    limits.body_part = kIsolatedInFacets, limits.factors = o.facet_parts;
    report("isolated chains of free forms removed", remove_isolated_chains(map, o.form_of, limits));
  }
  if (o.has_all_features) {
    report("isolated chains removed", remove_isolated_chains(map, o.object_of, isolated_limits(pen_mm, kLoneInPens, 1)));
  }
  if (o.has_outlines) {
    const EndLimits undershoots{kUndershootInGaps * gap_mm(o), kTouchingInPens * pen_mm};
    report("ends led to the line before them", extend_undershoots(map, undershoots, o.make_source));
  }
  if (o.is_outline) {
    report("gaps of outlines closed", close_outlines(map, gaps, o.is_outline, o.make_source));
  }
}

}  // namespace

CleanReport clean_lines(StrokeModel& model, const CleanOptions& options) {
  CleanReport report;
  const double step = model.lattice.step_mm, reach = kMeetingInPens * options.pen_mm / step;
  /// Side of the cells in which rules look for lines, in pen widths. Adjustable.
  constexpr double kCellInPens = 4;
  const double cell = kCellInPens * options.pen_mm / step, ink = kLineReachInPens * options.pen_mm / step;
  const EndLimits overshoots{kOvershootInPens * options.pen_mm, kTouchingInPens * options.pen_mm};
  // Passes in which dangles go and their gaps are closed.
  const int settling = options.form_of || options.scan_of ? 2 : 1;
  bool is_clean = false;
  std::vector<Stroke> joints;
  const auto count_changes = [&](std::string_view changes, std::size_t count) {
    auto rule = std::ranges::find(report.rules, changes, &RuleReport::changes);
    if (rule == report.rules.end()) rule = report.rules.insert(rule, {changes});
    rule->count += count;
    is_clean &= count == 0;
  };
  while (!is_clean && report.passes < kMostCleanPasses) {
    ++report.passes;
    is_clean = report.passes > 1 || (!options.form_of && !options.decimated_of);
    std::optional<LineMap> map;
    const auto make_map = [&] {
      map.emplace(
          model, [](const Stroke& s) { return s.line_class != LineClass::mesh; }, Meetings{.reach = reach}, cell);
    };
    const auto cut_ends = [&] {
      const std::size_t count = cut_overshoots(*map, overshoots);
      count_changes("ends behind other lines cut", count);
      return count > 0;
    };
    const auto commit = [&] {
      joints.insert(joints.end(), map->added().begin(), map->added().end());
      map->commit();
    };
    make_map();
    // Before, an end behind a crossing may be that of a dangle, or lie before a gap. Only a new map tells that an end that
    // was cut meets a line.
    if (report.passes > settling && cut_ends()) {
      commit();
      make_map();
    }
    apply_rules(*map, options, report.passes > 1, count_changes);
    if (report.passes <= settling && is_clean) cut_ends();
    if (!is_clean) commit();
  }
  clear_hidden(model.strokes, joints, ink);
  return report;
}

}  // namespace ligne
