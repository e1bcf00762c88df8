#pragma once
/// The common interval of two segments of the page, and their directions.

#include <cmath>
#include <optional>

#include "geometry/lattice.hpp"

namespace ligne {

/// The common interval of two segments, as fractions of each. At an end of the interval that is not an end of a, the
/// fraction of b is exactly 0 or 1, and vice versa.
struct SegmentOverlap {
  double a_from, a_to;  ///< on a, a_from < a_to
  double b_from, b_to;  ///< the fractions of b at the same places; b_from > b_to if b runs the other way
};

/// Length in tolerances above which a segment is long: its direction is reliable. Adjustable.
inline constexpr double kLongInTolerances = 64;
/// Largest line_directions::difference() at which two long segments coincide. Beyond it they share at most 60 tolerances,
/// near an end of each: too little to be seen.
inline constexpr double kDirectionReach = 1.0 / 15;

/// Projects the shorter segment onto the line of the longer one. The two coincide if their common interval there is
/// longer than the tolerance and the shorter segment is within the tolerance of that line at both ends of the interval.
/// So a wedge (two segments that leave one point at an angle) coincides only if the shorter segment ends within the
/// tolerance. Two long segments coincide only if their directions differ by at most kDirectionReach.
/// `tolerance` is in lattice steps.
std::optional<SegmentOverlap> overlap(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1, double tolerance);

/// Coordinates of the page for segments of similar direction. u is x or y, the axis nearer to that direction. v is the
/// other coordinate, sheared so that v hardly changes along such segments.
struct DirectionFrame {
  bool flat = true;  ///< u is x, v is y - slope x; otherwise u is y, v is x - slope y
  double slope = 0;  ///< in [-1, 1]

  double u(LatticePoint p) const { return flat ? p.x : p.y; }
  double v(LatticePoint p) const { return flat ? p.y - slope * p.x : p.x - slope * p.y; }
};

/// The directions of lines, as positions on a circle of length 4: by slope for lines nearer to the x axis, by inverse
/// slope for lines nearer to the y axis. Two lines at the angle a are at most 2 a apart.
namespace line_directions {

inline constexpr double kCircle = 4;

/// Returns a direction in [0, 4]. The two points must differ. It is the same for both orders of the points.
inline double direction(LatticePoint from, LatticePoint to) {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y;
  return std::abs(dx) >= std::abs(dy) ? dy / dx + 1 : 3 - dx / dy;
}

/// The difference of two directions, in [-2, 2].
inline double difference(double a, double b) {
  const double d = a - b;
  return d > kCircle / 2 ? d - kCircle : d < -kCircle / 2 ? d + kCircle : d;
}

/// The frame for lines near a direction.
inline DirectionFrame frame_of(double direction) {
  return direction < kCircle / 2 ? DirectionFrame{true, direction - 1} : DirectionFrame{false, 3 - direction};
}

}  // namespace line_directions

}  // namespace ligne
