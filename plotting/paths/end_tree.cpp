#include "plotting/paths/end_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/no_index.hpp"

namespace ligne {
namespace {

// Most points in a leaf. Adjustable.
constexpr std::uint32_t kLeafPoints = 8;

double squared_distance_of_points(Point2 a, Point2 b) {
  const Point2 d = a - b;
  return d.x * d.x + d.y * d.y;
}

inline double squared_distance_of_box(const Rect& box, Point2 p) {
  const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
  const double y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
  return x * x + y * y;
}

}  // namespace

EndTree::EndTree(std::span<const Point2> points)
    : points_(points.begin(), points.end()),
      order_(points.size()),
      place_of_(points.size()),
      leaf_of_(points.size()),
      there_(points.size(), 1) {
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(points.size() / 2 + 1);
  build(0, static_cast<std::uint32_t>(points.size()), 0);
  // Points are stored in the order of the leaves, so that a search reads neighbouring memory.
  for (std::uint32_t i = 0; i < order_.size(); ++i) {
    points_[i] = points[order_[i]];
    place_of_[order_[i]] = i;
  }
}

std::uint32_t EndTree::build(std::uint32_t first, std::uint32_t last, std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{{}, first, last};
  node.parent = parent;
  node.left_over = last - first;
  for (std::uint32_t i = first; i < last; ++i) node.box.extend(points_[order_[i]]);
  nodes_.push_back(node);
  if (last - first <= kLeafPoints) {
    for (std::uint32_t i = first; i < last; ++i) leaf_of_[order_[i]] = index;
    return index;
  }
  const int axis = node.box.width() >= node.box.height() ? 0 : 1;
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(
      order_.begin() + first, order_.begin() + middle, order_.begin() + last,
      [&](std::uint32_t l, std::uint32_t r) { return std::tie(points_[l][axis], l) < std::tie(points_[r][axis], r); });
  const std::uint32_t left = build(first, middle, index), right = build(middle, last, index);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

void EndTree::remove(std::uint32_t point) {
  there_[place_of_[point]] = 0;
  for (std::uint32_t node = leaf_of_[point];; node = nodes_[node].parent) {
    --nodes_[node].left_over;
    if (node == 0) return;
  }
}

template <class Take>
void EndTree::search(std::uint32_t index, Point2 p, const double& limit, const Take& take) const {
  const Node& node = nodes_[index];
  if (node.left_over == 0) return;
  if (node.left == 0) {
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      if (there_[i]) take(squared_distance_of_points(points_[i], p), order_[i]);
    }
    return;
  }
  std::uint32_t near = node.left, far = node.right;
  double near_distance = squared_distance_of_box(nodes_[near].box, p),
         far_distance = squared_distance_of_box(nodes_[far].box, p);
  if (far_distance < near_distance) {
    std::swap(near, far);
    std::swap(near_distance, far_distance);
  }
  // A box as far as the farthest point found holds nothing nearer. So a thousand ends in one point are not all visited.
  if (near_distance < limit) search(near, p, limit, take);
  if (far_distance < limit) search(far, p, limit, take);
}

std::uint32_t EndTree::nearest(Point2 p) const {
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t found = kNone;
  search(0, p, best, [&](double squared, std::uint32_t point) {
    if (squared < best) {
      best = squared;
      found = point;
    }
  });
  return found;
}

void EndTree::nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const {
  found.clear();
  if (count == 0) return;
  double limit = std::numeric_limits<double>::infinity();
  const auto nearer = [](const Neighbour& l, const Neighbour& r) {
    return std::tie(l.squared, l.point) < std::tie(r.squared, r.point);
  };
  search(0, p, limit, [&](double squared, std::uint32_t point) {
    if (!(squared < limit)) return;
    const Neighbour neighbour{squared, point};
    if (found.size() == count) found.pop_back();
    found.insert(std::upper_bound(found.begin(), found.end(), neighbour, nearer), neighbour);
    if (found.size() == count) limit = found.back().squared;
  });
}

}  // namespace ligne
