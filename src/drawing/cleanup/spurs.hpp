#pragma once
/// Outlines that leave an outline and lead nowhere.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "drawing/cleanup/flecks.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

struct SpurLimits {
  double longest_mm = 0;    ///< of a spur on the page
  double body_part = 0;     ///< and of the extent of its body's lines on the page
  double beside_mm = 0;     ///< what lies within this distance of a line runs beside it,
  double beside_times = 1;  ///< and is a spur up to so many times those lengths
  double touching_mm = 0;   ///< lines meet within this distance
  double gap_mm = 0;        ///< lines that end so far from each other may be one
};

/// Hides the spurs of outlines of rough bodies, or takes them out where no stroke is hidden. Where the surface is seen
/// nearly edge on, its outline comes from one shallow fold after the other: each ends freely beside the next. Lines are
/// taken as a graph, whose nodes are the ends of strokes and the places at which ends lie on lines; a way between two nodes
/// of one or of more than two arms is an arc. The shortest first, arcs are taken away that
/// - end freely, begin at a node that two other arms go on through, and are short;
/// - run beside another line all along, and end freely, or at two such nodes that are connected otherwise, too.
/// So lines stay connected; an arc also stays where other lines near its free end have no other way to its other end, since
/// they are one line with a gap. `body_of`: as of drop_flecks(). Returns the number of arcs. O(n + m), with m the grid cells
/// of the side of `touching_mm` x 16, and of `beside_mm` x 2, that lines pass, where few ends lie within `gap_mm` of each
/// other.
std::size_t drop_spurs(StrokeModel& model, const std::function<std::uint32_t(const Stroke&)>& body_of,
                       const SpurLimits& limits);

}  // namespace ligne
