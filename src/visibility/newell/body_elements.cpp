#include "visibility/newell/body_elements.hpp"

#include <algorithm>
#include <tuple>

namespace ligne::newell {

std::vector<Point2> convex_hull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), [](Point2 a, Point2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  // The lower chain from left to right, then the upper chain from right to left.
  for (const bool upper : {false, true}) {
    const std::size_t begin = hull.size();
    for (const Point2 p : points) {
      while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other chain begins with this point
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace ligne::newell
