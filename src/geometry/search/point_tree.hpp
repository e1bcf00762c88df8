#pragma once
/// A tree of bounding boxes over points of the page, which may have further coordinates.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ligne {

/// The coordinates of a point of the tree: the first two are a place on the page.
template <std::size_t N, class Coordinate = std::int32_t>
using TreePoint = std::array<Coordinate, N>;

/// Bounding box of points, parallel to the axes.
template <std::size_t N, class Coordinate = std::int32_t>
struct PointBox {
  TreePoint<N, Coordinate> low, high;

  /// Squared distance on the page. `Place` is a point with the members x and y.
  template <class Place>
  double squared_distance(const Place& p) const {
    const double dx = std::max({0.0, double(low[0]) - p.x, double(p.x) - high[0]});
    const double dy = std::max({0.0, double(low[1]) - p.y, double(p.y) - high[1]});
    return dx * dx + dy * dy;
  }
};

/// Divides the points into halves along the longest side of their box, where sides are multiplied by weights. The tree
/// depends on the points and weights alone.
template <std::size_t N, class Coordinate = std::int32_t>
class PointTree {
 public:
  using Point = TreePoint<N, Coordinate>;
  using Box = PointBox<N, Coordinate>;
  using Weights = std::array<double, N>;

  PointTree() = default;
  explicit PointTree(const std::vector<Point>& points, const Weights& weights = even_weights()) : order_(points.size()) {
    for (std::uint32_t i = 0; i < points.size(); ++i) order_[i] = i;
    nodes_.reserve(points.size() / (kLeafPoints / 2) + 1);
    if (!points.empty()) build(points, weights, 0, static_cast<std::uint32_t>(points.size()));
  }

  /// The numbers of the points, leaf by leaf.
  const std::vector<std::uint32_t>& order() const { return order_; }
  std::size_t node_count() const { return nodes_.size(); }
  const Box& box(std::uint32_t node) const { return nodes_[node].box; }
  /// The number of points in a node.
  std::uint32_t size_of(std::uint32_t node) const { return nodes_[node].end - nodes_[node].begin; }

  /// Calls visit(place in order()) for the points of each leaf for whose box, and for all boxes around it, enter(box)
  /// returns true.
  template <class Enter, class Visit>
  void search(const Enter& enter, const Visit& visit) const {
    for (std::uint32_t node = 0; node < nodes_.size();) {
      if (!enter(nodes_[node].box)) {
        node = nodes_[node].after;
        continue;
      }
      if (is_leaf(node)) visit_points(node, visit);
      ++node;
    }
  }

  /// Calls visit(place in order()) for the points of each leaf for which, and for all nodes around it, enter(node, squared
  /// distance of its box from p on the page) returns true. Of two nodes the nearer one comes first.
  template <class Place, class Enter, class Visit>
  void search_from(const Place& p, const Enter& enter, const Visit& visit) const {
    if (!nodes_.empty()) search_node(0, nodes_[0].box.squared_distance(p), p, enter, visit);
  }

  /// Calls visit(node) for the nodes around the point at a place in order(), from the root to its leaf.
  template <class Visit>
  void for_each_around(std::uint32_t place, const Visit& visit) const {
    for (std::uint32_t node = 0;;) {
      visit(node);
      if (is_leaf(node)) return;
      node = place < nodes_[node + 1].end ? node + 1 : nodes_[node + 1].after;
    }
  }

 private:
  static constexpr std::uint32_t kLeafPoints = 8;  ///< adjustable

  struct Node {
    Box box;
    std::uint32_t begin, end;  ///< range in order_
    std::uint32_t after = 0;   ///< the node that follows all nodes below this one; the first child is the next node
  };

  bool is_leaf(std::uint32_t node) const { return nodes_[node].after == node + 1; }

  template <class Visit>
  void visit_points(std::uint32_t node, const Visit& visit) const {
    for (std::uint32_t place = nodes_[node].begin; place < nodes_[node].end; ++place) visit(place);
  }

  static Weights even_weights() {
    Weights weights;
    weights.fill(1);
    return weights;
  }

  void build(const std::vector<Point>& points, const Weights& weights, std::uint32_t begin, std::uint32_t end) {
    const std::size_t node = nodes_.size();
    const std::span<std::uint32_t> here(order_.data() + begin, end - begin);
    Box box{points[here[0]], points[here[0]]};
    for (const std::uint32_t i : here) {
      for (std::size_t k = 0; k < N; ++k) {
        box.low[k] = std::min(box.low[k], points[i][k]);
        box.high[k] = std::max(box.high[k], points[i][k]);
      }
    }
    nodes_.push_back({box, begin, end});
    if (here.size() > kLeafPoints) {
      const auto side = [&](std::size_t k) { return weights[k] * (double(box.high[k]) - double(box.low[k])); };
      std::size_t axis = 0;
      for (std::size_t k = 1; k < N; ++k) axis = side(k) > side(axis) ? k : axis;
      const std::uint32_t middle = begin + divide(points, here, axis);
      build(points, weights, begin, middle);
      build(points, weights, middle, end);
    }
    nodes_[node].after = static_cast<std::uint32_t>(nodes_.size());
  }

  /// Sorts the points into two halves along an axis. Returns the number of the first half. Points with one coordinate stay
  /// together, so that a place where many lie is in few nodes.
  static std::uint32_t divide(const std::vector<Point>& points, std::span<std::uint32_t> here, std::size_t axis) {
    const auto at = [&](std::uint32_t i) { return points[i][axis]; };
    const auto middle = here.begin() + here.size() / 2;
    std::nth_element(here.begin(), middle, here.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b) || (at(a) == at(b) && a < b); });
    const auto value = at(*middle);
    const auto low = std::partition(here.begin(), middle, [&](std::uint32_t i) { return at(i) < value; });
    const auto high = std::partition(middle, here.end(), [&](std::uint32_t i) { return at(i) == value; });
    const bool has_low = low != here.begin(), has_high = high != here.end();
    const auto end = has_low && (!has_high || middle - low <= high - middle) ? low : has_high ? high : middle;
    return static_cast<std::uint32_t>(end - here.begin());
  }

  template <class Place, class Enter, class Visit>
  void search_node(std::uint32_t node, double squared, const Place& p, const Enter& enter, const Visit& visit) const {
    if (!enter(node, squared)) return;
    if (is_leaf(node)) return visit_points(node, visit);
    std::uint32_t near = node + 1, far = nodes_[near].after;
    double to_near = nodes_[near].box.squared_distance(p), to_far = nodes_[far].box.squared_distance(p);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    search_node(near, to_near, p, enter, visit);
    search_node(far, to_far, p, enter, visit);
  }

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace ligne
