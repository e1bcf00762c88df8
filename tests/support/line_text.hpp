#pragma once
/// Lines as text: "0,0 10,0; 5,5 6,6" are two. The words of a line, whose numbers are formulas:
///
///     X,Y                                    a point
///     FIRST..LAST:X,Y                        points by formulas of k
///     arc:X,Y,RX,RY,TURN,FROM,SWEEP,STEPS    corners of an ellipse, from an eccentric angle over a sweep; radians
///     ellipse:X,Y,RX,RY,TURN,STEPS           all of it, the first corner again at the end
///     walk:SEED,COUNT                        points at random steps from one to the next, on a lattice of an eighth
///     close                                  the first point again
///     each N                                 as many lines of N points
///     rectangle X,Y X,Y                      four corners

#include "drawing/drawing.hpp"
#include "support/standard.hpp"

namespace ligne::test {

Polylines lines_of_text(const std::string& text);
/// The first of the lines, or none.
std::vector<Point2> line_of_text(const std::string& text);
/// The lines as contours.
std::vector<std::vector<Point2>> contours_of_text(const std::string& text);

}  // namespace ligne::test
