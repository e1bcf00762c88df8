#include "geometry/point_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Most points in a leaf. Adjustable.
constexpr std::uint32_t kLeafPoints = 8;

}  // namespace

PointTree::PointTree(std::span<const Point2> points)
    : points_(points.begin(), points.end()),
      order_(points.size()),
      place_of_(points.size()),
      leaf_of_(points.size()),
      is_left_(points.size(), 1) {
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(points.size() / 2 + 1);
  build(0, static_cast<std::uint32_t>(points.size()), 0);
  // Points are stored in the order of the leaves, so that a search reads neighbouring memory.
  for (std::uint32_t i = 0; i < order_.size(); ++i) {
    points_[i] = points[order_[i]];
    place_of_[order_[i]] = i;
  }
}

std::uint32_t PointTree::build(std::uint32_t first, std::uint32_t last, std::uint32_t parent) {
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

void PointTree::remove(std::uint32_t point) {
  is_left_[place_of_[point]] = 0;
  for (std::uint32_t node = leaf_of_[point];; node = nodes_[node].parent) {
    --nodes_[node].left_over;
    if (node == 0) return;
  }
}

// A box as far as the farthest point found holds nothing nearer. So a thousand points in one place are not all visited.

std::uint32_t PointTree::nearest(Point2 p) const {
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t found = kNone;
  const auto enter = [&](double squared, const Rect&) { return squared < best; };
  search(p, enter, [&](double squared, std::uint32_t point) {
    if (squared >= best) return;
    best = squared;
    found = point;
  });
  return found;
}

void PointTree::nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const {
  found.clear();
  if (count == 0) return;
  double limit = std::numeric_limits<double>::infinity();
  const auto nearer = [](const Neighbour& l, const Neighbour& r) {
    return std::tie(l.squared, l.point) < std::tie(r.squared, r.point);
  };
  const auto enter = [&](double squared, const Rect&) { return squared < limit; };
  search(p, enter, [&](double squared, std::uint32_t point) {
    if (squared >= limit) return;
    const Neighbour neighbour{squared, point};
    if (found.size() == count) found.pop_back();
    found.insert(std::upper_bound(found.begin(), found.end(), neighbour, nearer), neighbour);
    if (found.size() == count) limit = found.back().squared;
  });
}

}  // namespace ligne
