#pragma once
/// Ranges of directions. Strokes with a long common interval have nearly the same direction, so most pairs of strokes
/// need no comparison, even where many strokes pass through one place.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

/// Coordinates of the page for strokes of similar direction. u is x or y, the axis nearer to that direction. v is the
/// other coordinate, sheared so that v hardly changes along such strokes.
struct DirectionFrame {
  bool flat = true;  ///< u is x, v is y - slope x; otherwise u is y, v is x - slope y
  double slope = 0;  ///< in [-1, 1]

  static bool is_flat(LatticePoint from, LatticePoint to) {
    return std::abs(double(to.x) - from.x) >= std::abs(double(to.y) - from.y);
  }
  double u(LatticePoint p) const { return flat ? p.x : p.y; }
  double v(LatticePoint p) const { return flat ? p.y - slope * p.x : p.x - slope * p.y; }
};

/// The directions of lines, as positions on a circle of length 4: by slope for lines nearer to the x axis, by inverse
/// slope for lines nearer to the y axis. Two lines at the angle a are at most 2 a apart.
namespace stroke_directions {

inline constexpr double kCircle = 4;
inline constexpr int kRanges = 28;  ///< adjustable
inline constexpr double kRange = kCircle / kRanges;

/// Bounds of long strokes, in tolerances. Strokes longer than kLong are long. Two of them have a common interval longer
/// than kCommon, or ends within kLong of each other. Both are adjustable; kCommon leaves room for the tolerance at both
/// ends and for rounding.
inline constexpr double kLong = 64, kCommon = 56;
/// Largest difference of direction between two strokes with a common interval of kCommon. Along the interval their
/// distance changes by at most two tolerances.
inline constexpr double kReach = 2 * 2 / kCommon;

/// Returns a direction in [0, 4]. The two points must differ.
inline double direction(LatticePoint from, LatticePoint to) {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y;
  return std::abs(dx) >= std::abs(dy) ? dy / dx + 1 : 3 - dx / dy;
}

/// Whether a typical stroke passes many ends of other strokes. The edges of a mesh do not.
bool are_crossing(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of);

inline int range_of(double direction) {
  const int range = static_cast<int>(std::floor(direction / kRange));
  return ((range % kRanges) + kRanges) % kRanges;
}

inline DirectionFrame frame_of(int range) {
  const double middle = (range + 0.5) * kRange;
  return middle < kCircle / 2 ? DirectionFrame{true, middle - 1} : DirectionFrame{false, 3 - middle};
}

/// Calls visit(range) for each range that may contain strokes with a long interval in common with a stroke of this
/// direction.
template <class Visit>
void for_each_range_near(double direction, const Visit& visit) {
  const int first = static_cast<int>(std::floor((direction - kReach) / kRange));
  const int last = static_cast<int>(std::floor((direction + kReach) / kRange));
  for (int range = first; range <= last; ++range) visit(((range % kRanges) + kRanges) % kRanges);
}

}  // namespace stroke_directions
}  // namespace ligne
