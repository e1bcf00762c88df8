#include "geometry/contour_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/parallel.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;

bool lexicographically_less(Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Fills positions and source; returns the position of every point.
std::vector<Index> number_positions(std::span<const Point2> points, ContourEdges& edges) {
  struct Numbered {
    Point2 point;
    Index index;
  };
  std::vector<Numbered> order;
  order.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) order.push_back({points[i], i});
  parallel_sort(order.begin(), order.end(), [](const Numbered& a, const Numbered& b) {
    return a.point != b.point ? lexicographically_less(a.point, b.point) : a.index < b.index;
  });
  std::vector<Index> position(points.size());
  for (const Numbered& n : order) {
    if (edges.positions.empty() || edges.positions.back() != n.point) {
      edges.positions.push_back(n.point);
      edges.source.push_back(n.index);
    }
    position[n.index] = static_cast<Index>(edges.positions.size() - 1);
  }
  return position;
}

}  // namespace

int sign_at_smallest_corner(std::span<const Point2> contour) {
  const std::size_t n = contour.size();
  const Point2 smallest = *std::min_element(contour.begin(), contour.end(), lexicographically_less);
  int sign = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    // Of equal corners in a row the first one speaks.
    if (contour[i] != smallest || contour[before] == smallest) continue;
    std::size_t after = (i + 1) % n;
    while (contour[after] == smallest) after = (after + 1) % n;
    const int turn = orientation_sign(contour[before], contour[i], contour[after]);
    if (turn != 0 && sign >= 0) sign = turn;
  }
  return sign;
}

int contour_sign(std::span<const Point2> contour) {
  if (contour.size() < 3) return 0;
  double twice_area = 0, size = 0;
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    const Point2 a = contour[i] - contour[0], b = contour[i + 1] - contour[0];
    twice_area += a.x * b.y - a.y * b.x;
    size += std::abs(a.x * b.y) + std::abs(a.y * b.x);
  }
  // Two roundings in each product's factors, one each in product, difference and sum over n terms, to first order.
  const double bound = (static_cast<double>(contour.size()) + 5) * std::numeric_limits<double>::epsilon() * size;
  if (std::abs(twice_area) > bound) return twice_area > 0 ? 1 : -1;
  return sign_at_smallest_corner(contour);
}

ContourEdges number_contour_edges(std::span<const Point2> points, std::span<const std::uint32_t> contour_end) {
  ContourEdges result;
  const std::vector<Index> position = number_positions(points, result);
  result.edges.reserve(points.size());
  std::size_t begin = 0;
  for (std::size_t c = 0; c < contour_end.size(); ++c) {
    const std::size_t end = contour_end[c];
    const int wanted = c == 0 ? 1 : -1;
    const bool turn_round = contour_sign(points.subspan(begin, end - begin)) != wanted;
    for (std::size_t i = begin; i < end; ++i) {
      const Index u = position[i], v = position[i + 1 < end ? i + 1 : begin];
      if (u != v) result.edges.push_back({std::min(u, v), std::max(u, v), (u < v) != turn_round ? 1 : -1});
    }
    begin = end;
  }
  return result;
}

void append_pieces(const std::vector<Point2>& positions, const SweepEdge& edge, std::vector<SweepEdge>& pieces) {
  const Point2 low = positions[edge.low], high = positions[edge.high];
  const auto [y_min, y_max] = std::minmax(low.y, high.y);
  Index from = edge.low;
  for (Index i = edge.low + 1; i < edge.high; ++i) {
    const Point2 q = positions[i];
    if (q.y < y_min || q.y > y_max || orientation_sign(low, high, q) != 0) continue;
    pieces.push_back({from, i, edge.winding});
    from = i;
  }
  pieces.push_back({from, edge.high, edge.winding});
}

}  // namespace ligne
