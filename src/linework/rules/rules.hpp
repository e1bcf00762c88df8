#pragma once
/// Rules that clean the lines of a drawing. Each reads a LineMap, edits it, and returns the number of its changes;
/// smooth_lines() comes before the map. Lengths are millimetres of the page. docs/linework.md lists the rules in their
/// order, with their parameters.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "linework/map/line_map.hpp"

namespace ligne {

/// Whether an outline of a body lies beside the way from one point of the page to another, mm; with `along`, whether it runs
/// in this direction.
using IsOutline = std::function<bool(Point2 from, Point2 to, bool along)>;

/// Numbers the bodies of strokes from 0. Returns kNone for strokes that the rule ignores.
using BodyOf = std::function<std::uint32_t(const Stroke&)>;

/// No limit of the number of edges.
inline constexpr std::size_t kAnySources = std::numeric_limits<std::size_t>::max();

struct GapLimits {
  double gap_mm = 0;  ///< ends nearer than this are joined if their lines point towards each other within 60 degrees
  /// Longest bridge of long lines within 20 degrees. From three gaps on the limit is 10 degrees. The bridge must be clear
  /// of other lines.
  double wide_mm = 0;
  double clear_mm = 0;  ///< least distance of other lines from such a bridge
};
/// bridge_gaps: joins two free ends if each is the nearest of the ends that the other may be joined to. Adds one stroke
/// for each bridge. O(n log n).
std::size_t bridge_gaps(LineMap& map, const GapLimits& limits, const MakeSource& make_source);

/// close_outlines: joins a free end of an outline to the nearest end of another outline if an outline of a body runs between
/// the two. Where that other end is not free, the outline must have the direction of the bridge. Adds one stroke for each
/// bridge of up to `wide_mm`, from the middle of which other lines are `clear_mm` away. O(n log n).
std::size_t close_outlines(LineMap& map, const GapLimits& limits, const IsOutline& is_outline,
                           const MakeSource& make_source);

struct DangleLimits {
  double longest_mm = 0;                   ///< longest dangle
  double body_part = 0;                    ///< longest dangle as part of the extent of its body's lines
  double beside_mm = 0;                    ///< an arc within this distance of another line runs beside it
  double beside_times = 1;                 ///< such an arc may be this many times as long as a dangle
  double touching_mm = 0;                  ///< lines meet within this distance
  std::size_t most_sources = kAnySources;  ///< largest number of edges that a dangle consists of
  std::span<const double> factors{};       ///< per body: multiplies body_part; empty: 1
};
/// prune_dangles: removes outlines of bodies that branch off an outline and lead nowhere. Where a rough surface is seen
/// nearly edge on, its outline follows many shallow folds, and each ends freely beside the next. The rule removes arcs
/// (Arcs in line_groups.hpp), the shortest first, if they
/// - end freely, begin at a junction of two other arcs, and are short; or
/// - run beside another line all along, and end freely or between two such junctions that stay connected without them.
std::size_t prune_dangles(LineMap& map, const BodyOf& body_of, const DangleLimits& limits);

/// merge_short_runs: gives runs (Runs in line_groups.hpp) shorter than `least_mm` the class of the longest run that
/// continues them, if that is longer. The class of a rim is decided edge by edge, so it alternates where the rim is
/// seen along its plane. Edges of class mesh take no part. O(n log n).
std::size_t merge_short_runs(LineMap& map, double least_mm);

/// remove_short_bits: removes chains of edges shorter than `least_mm` that meet no other line at either end, if
/// visibility cuts off at least one of their ends, or if all are intersections. Short edges and small features that are
/// whole stay. O(n).
std::size_t remove_short_bits(LineMap& map, double least_mm);

struct OverdrawLimits {
  double longest_mm = 0;  ///< longest run that may be removed
  double ink_mm = 0;      ///< distance that the ink of a line reaches to either side
  double shown_mm = 0;    ///< a run stays if at least this length lies outside of the ink of other lines
};
/// remove_overdrawn_runs: removes short runs that do not show beside the ink of longer ones: dangles beside outlines,
/// edges seen end on, short lines between lines that nearly touch. Strokes that rules added stay where they are alone.
std::size_t remove_overdrawn_runs(LineMap& map, const OverdrawLimits& limits);

struct IsolatedLimits {
  double longest_mm = 0;                   ///< diagonal of the bounding box of the largest cluster that is removed
  double body_part = 0;                    ///< the same as part of the extent of the lines of its body
  double ring_width_mm = 0;                ///< a ring no wider than this is a line there and back
  double straight_times = 1;               ///< a cluster all of whose points lie on one line may be so many times as large
  std::size_t most_sources = kAnySources;  ///< largest number of edges that a cluster consists of
  std::span<const double> factors{};       ///< per body: multiplies body_part; empty: 1
};
/// remove_isolated_chains: removes short clusters of lines. Lines that share a node or have a contact belong to one
/// cluster. Clusters with rings stay unless all their points lie on one line.
std::size_t remove_isolated_chains(LineMap& map, const BodyOf& body_of, const IsolatedLimits& limits);

struct EndLimits {
  double longest_mm = 0;   ///< longest extension of a line, or longest part that is removed
  double touching_mm = 0;  ///< lines meet within this distance
};
/// extend_undershoots: extends a free end straight ahead to the next line. If there is none, extends it to the nearest
/// point of a line in a wedge of 20 degrees to either side, so that no line ends beside one of nearly its direction.
/// The line must be several times as long as the extension. Adds one stroke for each end.
std::size_t extend_undershoots(LineMap& map, const EndLimits& limits, const MakeSource& make_source);

/// cut_overshoots: cuts lines with a free end where they cross another line, if they end soon behind it: no two lines of
/// surfaces cross each other in sight. Of two lines that end behind their crossing the shorter end is cut.
std::size_t cut_overshoots(LineMap& map, const EndLimits& limits);

/// smooth_lines: smooths the lines of the strokes for which is_rough() holds. The vertices of a scan lie on both sides of a
/// ridge, so the edges along it zigzag. A point moves if exactly two strokes meet there, both rough and of equal visibility.
/// It moves towards the middle of its neighbours and back, several times. Ends, junctions and corners stay. Returns the
/// number of points moved. O(n).
std::size_t smooth_lines(StrokeModel& model, const std::function<bool(const Stroke&)>& is_rough);

/// Adds an edge to those of a line if their number is limited. No more than one more than `most` are kept.
inline void add_source(std::vector<std::uint32_t>& sources, std::uint32_t source, std::size_t most) {
  if (most == kAnySources || sources.size() > most) return;
  if (std::ranges::find(sources, source) == sources.end()) sources.push_back(source);
}

/// The body of each piece; kNone for removed pieces and those that `body_of` ignores. Runs in parallel.
std::vector<std::uint32_t> bodies_of(const LineMap& map, const BodyOf& body_of);

/// Longest line of each body that a rule removes, in lattice steps. `body_part` is a part of the diagonal of the bounding
/// box of its pieces, `factors` as in the limits of rules, `bodies` by piece.
std::vector<double> longest_of_bodies(const LineMap& map, std::span<const std::uint32_t> bodies, double longest_mm,
                                      double body_part, std::span<const double> factors);

}  // namespace ligne
