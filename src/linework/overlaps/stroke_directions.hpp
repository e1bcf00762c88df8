#pragma once
/// Ranges of directions: strokes that lie on each other for a while have nearly one direction, so most strokes need never
/// be held against each other, however many of them pass through one place.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

/// Coordinates of the page for strokes of about one direction: u along the x axis or the y axis, whichever is nearer to it,
/// and v across, sheared so that such strokes hardly change in v.
struct DirectionFrame {
  bool flat = true;  ///< u is x, v is y - slope x; otherwise u is y, v is x - slope y
  double slope = 0;  ///< in [-1, 1]

  static bool is_flat(LatticePoint from, LatticePoint to) {
    return std::abs(double(to.x) - from.x) >= std::abs(double(to.y) - from.y);
  }
  double u(LatticePoint p) const { return flat ? p.x : p.y; }
  double v(LatticePoint p) const { return flat ? p.y - slope * p.x : p.x - slope * p.y; }
};

/// The directions of lines, numbered along a circle of length 4: by slope where they are nearer to the x axis, and by the
/// inverse slope where they are nearer to the y axis. Two lines at the angle a are at most 2 a apart.
namespace stroke_directions {

inline constexpr double kCircle = 4;
inline constexpr int kRanges = 28;  ///< adjustable
inline constexpr double kRange = kCircle / kRanges;

/// Longer strokes are long: what they have in common is longer than kCommon tolerances, or ends of theirs are as near to
/// each other as kLong tolerances. Both adjustable; kCommon leaves room for the tolerance at both ends, and for roundings.
inline constexpr double kLong = 64, kCommon = 56;
/// How far the directions of two strokes with so long a common interval are apart: within it they are at most two tolerances
/// farther from each other at one end than at the other.
inline constexpr double kReach = 2 * 2 / kCommon;

/// In [0, 4]. The two points differ.
inline double direction(LatticePoint from, LatticePoint to) {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y;
  return std::abs(dx) >= std::abs(dy) ? dy / dx + 1 : 3 - dx / dy;
}

/// Whether the common stroke has many ends of others in its way. The edges of a mesh have not.
bool are_crossing(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of);

inline int range_of(double direction) {
  const int range = static_cast<int>(std::floor(direction / kRange));
  return ((range % kRanges) + kRanges) % kRanges;
}

inline DirectionFrame frame_of(int range) {
  const double middle = (range + 0.5) * kRange;
  return middle < kCircle / 2 ? DirectionFrame{true, middle - 1} : DirectionFrame{false, 3 - middle};
}

/// Calls visit(range) for the ranges in which strokes may be that have a long interval in common with one of this direction.
template <class Visit>
void for_each_range_near(double direction, const Visit& visit) {
  const int first = static_cast<int>(std::floor((direction - kReach) / kRange));
  const int last = static_cast<int>(std::floor((direction + kReach) / kRange));
  for (int range = first; range <= last; ++range) visit(((range % kRanges) + kRanges) % kRanges);
}

}  // namespace stroke_directions
}  // namespace ligne
