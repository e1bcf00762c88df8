#pragma once
/// A tree of bounding boxes over points of the page.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// Bounding box of points, parallel to the axes.
struct PointBox {
  LatticePoint low, high;

  double squared_distance(LatticePoint p) const {
    const double dx = std::max({0.0, double(low.x) - p.x, double(p.x) - high.x});
    const double dy = std::max({0.0, double(low.y) - p.y, double(p.y) - high.y});
    return dx * dx + dy * dy;
  }
};

/// Divides the points into halves along the longer side of their box.
class PointTree {
 public:
  PointTree() = default;
  explicit PointTree(const std::vector<LatticePoint>& points) : number_(points.size()) {
    for (std::uint32_t i = 0; i < points.size(); ++i) number_[i] = i;
    if (!points.empty()) build(points, 0, static_cast<std::uint32_t>(points.size()));
  }

  /// Calls visit(number) for all points in each leaf for whose box, and all boxes around it, enter(box) returns true.
  /// The child nearer to p is searched first.
  template <class Enter, class Visit>
  void search(LatticePoint p, const Enter& enter, const Visit& visit) const {
    if (!nodes_.empty()) search_node(0, p, enter, visit);
  }

 private:
  static constexpr std::uint32_t kLeafSize = 8;  ///< adjustable

  struct Node {
    PointBox box;
    std::uint32_t begin, end;  ///< range in number_
    std::uint32_t second = 0;  ///< second child; the first child follows the node; 0 in a leaf
  };

  void build(const std::vector<LatticePoint>& points, std::uint32_t begin, std::uint32_t end) {
    const std::size_t node = nodes_.size();
    const std::span<std::uint32_t> here(number_.data() + begin, end - begin);
    PointBox box{points[here[0]], points[here[0]]};
    for (const std::uint32_t i : here) {
      box.low = {std::min(box.low.x, points[i].x), std::min(box.low.y, points[i].y)};
      box.high = {std::max(box.high.x, points[i].x), std::max(box.high.y, points[i].y)};
    }
    nodes_.push_back({box, begin, end});
    if (here.size() <= kLeafSize) return;
    const bool by_x = double(box.high.x) - box.low.x > double(box.high.y) - box.low.y;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(here.begin(), here.begin() + (middle - begin), here.end(), [&](std::uint32_t a, std::uint32_t b) {
      return by_x ? points[a].x < points[b].x : points[a].y < points[b].y;
    });
    build(points, begin, middle);
    nodes_[node].second = static_cast<std::uint32_t>(nodes_.size());
    build(points, middle, end);
  }

  template <class Enter, class Visit>
  void search_node(std::uint32_t number, LatticePoint p, const Enter& enter, const Visit& visit) const {
    const Node& node = nodes_[number];
    if (!enter(node.box)) return;
    if (node.second == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) visit(number_[i]);
      return;
    }
    std::uint32_t first = number + 1, then = node.second;
    if (nodes_[then].box.squared_distance(p) < nodes_[first].box.squared_distance(p)) std::swap(first, then);
    search_node(first, p, enter, visit);
    search_node(then, p, enter, visit);
  }

  std::vector<std::uint32_t> number_;  ///< numbers of the points, in the order of the leaves
  std::vector<Node> nodes_;
};

}  // namespace ligne
