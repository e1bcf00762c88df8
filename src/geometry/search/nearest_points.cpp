#include "geometry/search/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ligne {

NearestPoints::NearestPoints(std::span<const Point2> points)
    : points_(points.size()), place_of_(points.size()), is_left_(points.size(), 1) {
  std::vector<TreePoint<2, double>> places;
  places.reserve(points.size());
  for (const Point2 p : points) places.push_back({p.x, p.y});
  tree_ = PointTree<2, double>(places);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    points_[i] = points[tree_.order()[i]];
    place_of_[tree_.order()[i]] = i;
  }
  for (std::uint32_t node = 0; node < tree_.node_count(); ++node) left_in_.push_back(tree_.size_of(node));
}

void NearestPoints::remove(std::uint32_t point) {
  is_left_[place_of_[point]] = 0;
  tree_.for_each_around(place_of_[point], [&](std::uint32_t node) { --left_in_[node]; });
}

void NearestPoints::nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const {
  found.clear();
  double limit = count > 0 ? std::numeric_limits<double>::infinity() : 0;
  const auto nearer = [](const Neighbour& l, const Neighbour& r) {
    return std::tie(l.squared, l.point) < std::tie(r.squared, r.point);
  };
  // A box as far as the farthest point found holds nothing nearer, so a thousand points in one place are not all visited.
  const auto enter = [&](std::uint32_t node, double squared) { return left_in_[node] > 0 && squared < limit; };
  tree_.search_from(p, enter, [&](std::uint32_t i) {
    const Point2 d = points_[i] - p;
    const Neighbour neighbour{d.x * d.x + d.y * d.y, tree_.order()[i]};
    if (!is_left_[i] || !(neighbour.squared < limit)) return;
    if (found.size() == count) found.pop_back();
    found.insert(std::upper_bound(found.begin(), found.end(), neighbour, nearer), neighbour);
    if (found.size() == count) limit = found.back().squared;
  });
}

bool NearestPoints::any_within(Point2 center, Point2 half) const {
  bool found = false;
  const auto enter = [&](const PointBox<2, double>& box) {
    bool is_inside = true;
    for (int axis = 0; axis < 2; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const double low = box.low[k] - center[axis], high = box.high[k] - center[axis];
      if (found || low >= half[axis] || high <= -half[axis]) return false;
      is_inside = is_inside && std::max(std::abs(low), std::abs(high)) < half[axis];
    }
    found = is_inside;
    return !found;
  };
  tree_.search(enter, [&](std::uint32_t i) {
    const Point2 d = points_[i] - center;
    found = found || (std::abs(d.x) < half.x && std::abs(d.y) < half.y);
  });
  return found;
}

}  // namespace ligne
