#include "linework/near_part.hpp"

#include <cmath>

namespace ligne {

/// The part is the hull of the parts in the two discs around the ends of the other stroke and in the strip between
/// them.
StrokePart part_near(const Stroke& bit, const Stroke& line, double reach) {
  const double dx = double(bit.to.x) - bit.from.x, dy = double(bit.to.y) - bit.from.y, square = dx * dx + dy * dy;
  StrokePart part;
  for (const LatticePoint end : {line.from, line.to}) {
    const double px = double(end.x) - bit.from.x, py = double(end.y) - bit.from.y;
    const double middle = (px * dx + py * dy) / square, beside = std::abs(px * dy - py * dx) / std::sqrt(square);
    if (beside > reach) continue;
    const double half = std::sqrt((reach - beside) * (reach + beside) / square);
    part.add(middle - half, middle + half);
  }
  const double ux = double(line.to.x) - line.from.x, uy = double(line.to.y) - line.from.y, length = std::hypot(ux, uy);
  if (length == 0) return part;
  // Clips to the fractions at which the distances along and across the other stroke are in range. Both are linear in
  // the fraction.
  double from = 0, to = 1;
  const auto clip = [&](double start, double slope, double low, double high) {
    if (slope == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double a = (low - start) / slope, b = (high - start) / slope;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  const double fx = double(bit.from.x) - line.from.x, fy = double(bit.from.y) - line.from.y;
  clip((fx * ux + fy * uy) / length, (dx * ux + dy * uy) / length, 0, length);
  clip((fx * uy - fy * ux) / length, (dx * uy - dy * ux) / length, -reach, reach);
  part.add(from, to);
  return part;
}

}  // namespace ligne
