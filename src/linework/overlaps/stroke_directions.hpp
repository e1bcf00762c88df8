#pragma once
/// Directions of strokes. Two long strokes that lie on each other have nearly the same direction.

#include <cmath>

#include "linework/stroke_geometry.hpp"

namespace ligne {

/// Coordinates of the page for strokes of similar direction. u is x or y, the axis nearer to that direction. v is the
/// other coordinate, sheared so that v hardly changes along such strokes.
struct DirectionFrame {
  bool flat = true;  ///< u is x, v is y - slope x; otherwise u is y, v is x - slope y
  double slope = 0;  ///< in [-1, 1]

  double u(LatticePoint p) const { return flat ? p.x : p.y; }
  double v(LatticePoint p) const { return flat ? p.y - slope * p.x : p.x - slope * p.y; }
};

/// The directions of lines, as positions on a circle of length 4: by slope for lines nearer to the x axis, by inverse
/// slope for lines nearer to the y axis. Two lines at the angle a are at most 2 a apart.
namespace stroke_directions {

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

}  // namespace stroke_directions
}  // namespace ligne
