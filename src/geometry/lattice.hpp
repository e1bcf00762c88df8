#pragma once
/// The integer lattice of the page.
///
/// After projection every x and y is a whole number of lattice steps, |x|, |y| <= 2^25. A difference of two coordinates
/// then has 26 bits, a product of two differences 52, and the sum of two such products 53: every orientation determinant
/// is exact in plain double arithmetic, with no filter and no fallback. The step is a power of two in millimetres, about
/// 8 nm on A4 and 31 nm on A0, far below the micrometre that a drawing needs. See docs/numerics.md.

#include <cmath>
#include <compare>
#include <cstdint>

#include "geometry/point.hpp"

namespace ligne {

/// A point of the page lattice, in steps from the lattice's origin.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  /// Equality, and the order by x, then by y, for sorting.
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// Largest coordinate for which orientation() is exact.
inline constexpr std::int32_t kLatticeLimit = 1 << 25;

/// Twice the signed area of the triangle a, b, c in square steps; exact for |coordinate| <= kLatticeLimit.
/// Positive when a -> b -> c turns from +x towards +y (clockwise on the page, whose y axis points down).
/// Identities: orientation(a,b,c) == orientation(b,c,a) == -orientation(b,a,c); 0 when two points are equal or all three
/// are collinear.
inline double orientation(LatticePoint a, LatticePoint b, LatticePoint c) {
  const double abx = double(b.x) - a.x, aby = double(b.y) - a.y;
  const double acx = double(c.x) - a.x, acy = double(c.y) - a.y;
  return abx * acy - aby * acx;
}

/// Maps page millimetres (x right, y down, origin top left) to lattice steps and back.
struct Lattice {
  Point2 origin_mm{0, 0};  ///< page position of lattice point (0, 0); a whole number of steps
  double step_mm = 1;      ///< a power of two

  /// The finest lattice that holds the rectangle and `margin_steps` of its steps around it. Rectangles without area are
  /// allowed; an empty one gives a step of 1 mm.
  static Lattice covering(const Rect& page_mm, int margin_steps = 0);

  /// Nearest lattice point; coordinates outside the limit are clamped to it.
  LatticePoint snap(Point2 mm) const;
  Point2 to_mm(LatticePoint p) const { return {origin_mm.x + p.x * step_mm, origin_mm.y + p.y * step_mm}; }
};

/// Length of a segment, lattice steps. The sum is exact on the lattice, and std::hypot() takes ten times as long.
inline double length(LatticePoint a, LatticePoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace ligne
