#pragma once
/// Joins the strokes of one pen: removes coincident lines, and connects ends.

#include "drawing/drawing.hpp"

namespace ligne {

/// Tolerances in page mm. They are below what a pen shows: its line is some tenths of a millimetre wide, and the step
/// of a plotter is 0.025 mm.
struct JoinTolerances {
  double ends_mm = 0.05;      ///< ends within this distance are joined by a straight segment
  double overlap_mm = 0.01;   ///< segments that coincide within this distance are drawn once; 0 keeps all
  double simplify_mm = 0.01;  ///< largest distance of a removed point from the simplified line; 0 removes only points
                              ///< on straight lines
  /// Largest fraction of its length that a line may lose by simplification, since ink is length times width. A circle
  /// keeps at least 41 points.
  double simplify_loss = 0.001;
};

/// Draws the lines with as few strokes as possible. Where strokes meet in a point, the pairs that make the straightest
/// lines are joined first, then the remaining ones at any angle. Closed lines are inserted into lines that pass one of
/// their points. Loose ends within the tolerance are joined, nearest first. So a connected figure takes half as many
/// strokes as it has points where an odd number of lines meet. The strokes are in the order of the first lines in them.
/// A line without length stays as a dot of two equal points.
///
/// No point of the result is farther from the input, and no point of the input is farther from the result, than the sum
/// of ends_mm, overlap_mm and simplify_mm.
Polylines join_strokes(const Polylines& lines, const JoinTolerances& tolerances);

/// Joins polylines whose ends lie within the tolerance of each other by a straight segment, the nearest first. The two
/// ends of one polyline are joined only if it is several times as long as the gap. Closed polylines stay as they are. The
/// results are ordered by the first polyline in each.
Polylines join_near_ends(const Polylines& lines, double tolerance_mm);

}  // namespace ligne
