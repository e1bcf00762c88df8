#pragma once
/// Rules that clean the lines of a drawing. Each reads a LineMap, edits it, and returns the number of its changes. Lengths
/// are millimetres of the page. docs/linework.md lists the rules in their order, with their parameters.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/no_index.hpp"
#include "linework/map/line_map.hpp"

namespace ligne {

/// Numbers the bodies that strokes belong to from 0 on; kNone for strokes that a rule leaves alone.
using BodyOf = std::function<std::uint32_t(const Stroke&)>;

struct GapLimits {
  double gap_mm = 0;    ///< ends less than this apart are joined if their lines go on towards each other, within 60 degrees
  double wide_mm = 0;   ///< ends of long lines, within 20 degrees (10 from three gaps on; 4 between lines that are not so
                        ///< long, up to six gaps), are joined up to this distance if no line is within
  double clear_mm = 0;  ///< this distance of the bridge
};
/// bridge_gaps: joins two free ends, each of which is the nearest to the other of those that it may be joined to. Adds one
/// stroke for each bridge. O(n log n).
std::size_t bridge_gaps(LineMap& map, const GapLimits& limits, const MakeSource& make_source);

struct DangleLimits {
  double longest_mm = 0;    ///< length of a dangle,
  double body_part = 0;     ///< and as part of the extent of its body's lines
  double beside_mm = 0;     ///< an arc within this distance of another line runs beside it,
  double beside_times = 1;  ///< and may be so many times as long
  double touching_mm = 0;   ///< lines meet within this distance
  double gap_mm = 0;        ///< lines that end so far from each other may be one line
};
/// prune_dangles: removes outlines of bodies that leave an outline and lead nowhere. Where a rough surface is seen nearly
/// edge on, its outline comes from one shallow fold after the other, and each ends freely beside the next. Arcs (Arcs in
/// line_groups.hpp) go, the shortest first, if they
/// - end freely, begin at a junction of two other arcs, and are short; or
/// - run beside another line all along, and end freely or between two such junctions that stay connected without them.
/// An arc stays if other lines near its free end have no other way to its other end: they are one line with a gap.
std::size_t prune_dangles(LineMap& map, const BodyOf& body_of, const DangleLimits& limits);

/// merge_short_runs: gives runs (Runs in line_groups.hpp) shorter than `least_mm` the class of the longest run that
/// continues them, if that is longer. The class of a rim is decided edge by edge, and changes to and fro where the rim is
/// seen along its plane. Edges of class mesh neither give nor take. O(n log n).
std::size_t merge_short_runs(LineMap& map, double least_mm);

/// remove_short_bits: removes chains of edges shorter than `least_mm` that end at no end of another line, if visibility cuts
/// off at least one of their ends, or if all are intersections. Short edges and small features stay, since they are whole.
/// O(n).
std::size_t remove_short_bits(LineMap& map, double least_mm);

struct OverdrawLimits {
  double longest_mm = 0;  ///< runs shorter than this may go
  double ink_mm = 0;      ///< distance that the ink of a line reaches to either side
  double shown_mm = 0;    ///< length outside of the ink of other lines from which on a run shows
};
/// remove_overdrawn_runs: removes short runs that do not show beside the ink of longer ones: dangles beside outlines, edges
/// seen end on, rungs between lines that nearly touch. Runs that end where others end count together.
std::size_t remove_overdrawn_runs(LineMap& map, const OverdrawLimits& limits);

struct IsolatedLimits {
  double longest_mm = 0;   ///< side of the box round what goes,
  double body_part = 0;    ///< and its length as part of the extent of its body's lines
  double touching_mm = 0;  ///< lines meet within this distance
  LineClasses classes{1u << static_cast<unsigned>(LineClass::outline)};
  std::uint32_t most_ends_on_lines = 1;
  double ring_width_mm = 0;  ///< a ring that is no wider is a line to and fro
};
/// remove_isolated_chains: removes short open chains of the classes that stand alone, and rings that are lines to and fro.
/// Chains that touch count together. A chain stays if another line ends on it, since that line goes on behind it, or if more
/// of its ends lie on lines than the limits say.
std::size_t remove_isolated_chains(LineMap& map, const BodyOf& body_of, const IsolatedLimits& limits);

struct UndershootLimits {
  double reach_mm = 0;     ///< how far a line may be led on
  double touching_mm = 0;  ///< lines meet within this distance
};
/// extend_undershoots: leads a free end to the line that it would run into if it went straight on; else, if there is one in
/// a wedge of 20 degrees to either side, to the nearest place there, so that no line ends beside one of nearly its own
/// direction. The line must be some times as long as the way. Adds one stroke for each end.
std::size_t extend_undershoots(LineMap& map, const UndershootLimits& limits, const MakeSource& make_source);

/// The diagonals of the boxes round the pieces of each body, lattice steps.
std::vector<double> body_extents(const LineMap& map, const BodyOf& body_of);

}  // namespace ligne
