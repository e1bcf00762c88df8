#pragma once
/// Ends of lines between which nothing shows.

#include <cstddef>
#include <functional>

#include "drawing/stroke.hpp"

namespace ligne {

/// Where a stroke of no edge comes from, whose source is still that of the line that it belongs to.
using MakeSource = std::function<SourceEdge(const Stroke&)>;

struct JointLimits {
  double gap_mm = 0;    ///< ends less than this apart are joined where the lines go on towards each other, within 60 degrees
  double wide_mm = 0;   ///< and so are those of long lines, within 20 degrees (of three gaps: 10; where one is not so long:
                        ///< 4, up to six gaps), where no line is within
  double clear_mm = 0;  ///< this distance of the joint
};

/// Joins lines of which each ends nearest to the end of the other, where no other line ends: a stroke between the two ends
/// is added, with a source of its own. Hidden strokes along it are taken out. Nothing is added to the mesh's own lines. No
/// two visible strokes coincide. Returns the number of such strokes. O(n + m), with m the grid cells of the side of
/// `wide_mm` x 2 that lines pass near the wide joints.
std::size_t join_loose_ends(StrokeModel& model, const JointLimits& limits, const MakeSource& make_source);

}  // namespace ligne
