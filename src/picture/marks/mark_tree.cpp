#include "picture/marks/mark_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ligne {
namespace {

/// Largest number of points in a leaf, which are tested one by one.
constexpr std::size_t kMostInLeaf = 8;

}  // namespace

MarkTree::MarkTree(std::vector<Point2> points) : points_(std::move(points)) {
  if (!points_.empty()) build();
}

void MarkTree::build() {
  nodes_.push_back({0, points_.size(), 0, {}});
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const std::size_t begin = nodes_[k].begin, end = nodes_[k].end;
    Rect bounds;
    for (std::size_t i = begin; i < end; ++i) bounds.extend(points_[i]);
    nodes_[k].bounds = bounds;
    if (end - begin <= kMostInLeaf || bounds.min == bounds.max) continue;
    const int axis = bounds.width() < bounds.height() ? 1 : 0;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](Point2 a, Point2 b) { return a[axis] < b[axis]; });
    nodes_[k].left = nodes_.size();
    nodes_.push_back({begin, middle, 0, {}});
    nodes_.push_back({middle, end, 0, {}});
  }
}

bool MarkTree::any_within(std::size_t node, Point2 center, Point2 half) const {
  const Node& n = nodes_[node];
  bool inside = true;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = n.bounds.min[axis] - center[axis], high = n.bounds.max[axis] - center[axis];
    if (low >= half[axis] || high <= -half[axis]) return false;
    inside = inside && std::max(std::abs(low), std::abs(high)) < half[axis];
  }
  if (inside) return true;
  if (n.left != 0) return any_within(n.left, center, half) || any_within(n.left + 1, center, half);
  return std::any_of(points_.begin() + static_cast<std::ptrdiff_t>(n.begin),
                     points_.begin() + static_cast<std::ptrdiff_t>(n.end),
                     [&](Point2 p) { return std::abs(p.x - center.x) < half.x && std::abs(p.y - center.y) < half.y; });
}

}  // namespace ligne
