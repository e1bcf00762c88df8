#pragma once
/// The convex hull of points of the plane.

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// Corners of the convex hull, positively turned, without points inside a side; the ends of the line on which all points
/// lie. turn(a, b, c) is positive if a -> b -> c turns from +x towards +y. Monotone chains [Andrew1979], O(n log n).
template <class Point, class Turn>
std::vector<Point> convex_hull(std::vector<Point> points, const Turn& turn) {
  std::ranges::sort(points, [](const Point& a, const Point& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other half begins with this point
    std::ranges::reverse(points);
  }
  return hull;
}

/// The hull by exact signs.
inline std::vector<LatticePoint> convex_hull(std::vector<LatticePoint> points) {
  return convex_hull(std::move(points), orientation);
}

}  // namespace ligne
