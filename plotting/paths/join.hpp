#pragma once
/// Strokes of one pen: every line once, ends joined.

#include "drawing/drawing.hpp"

namespace ligne {

/// How near is together, in page mm. What a pen shows: its line is some tenths of a millimetre wide, and a plotter's step is
/// 0.025 mm.
struct JoinTolerances {
  double ends_mm = 0.05;     ///< ends so near to each other become one stroke, by a straight piece from one to the other
  double overlap_mm = 0.01;  ///< segments that lie on each other within this are drawn once; zero leaves them
  /// A part that a line loses to another, between two parts that stay, is drawn all the same where it is shorter than this
  /// and the pen would have to be lifted for it.
  double lift_mm = 10;
  double simplify_mm = 0.01;  ///< how far the line may leave the points that are left out; zero keeps all that turn
  /// Part of its length that a line may lose by that: ink is length times width. A circle keeps 41 points at the least.
  double simplify_loss = 0.001;
};

/// Draws the lines with as few strokes as their ends allow: where strokes meet in a point the straightest continue each
/// other, what then is left goes on at any angle, closed lines are taken into others that pass one of their points, and the
/// ends that stay loose are joined within the tolerance, nearest first. So every connected figure is drawn with half as many
/// strokes as it has points where an odd number of lines meet. Strokes follow each other as their first lines did. A line
/// without length stays, as a dot of two equal points.
///
/// A line that loses pieces to others is cut only where that spares more way than a lift takes time.
///
/// No point of the result is farther from the input, and no point of the input from the result, than the sum of the three
/// tolerances.
Polylines join_strokes(const Polylines& lines, const JoinTolerances& tolerances);

}  // namespace ligne
