#include "geometry/polygons/contour_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;

/// Smallest number of positions in a block. The positions between near ends, at most as many, are tested one by one.
/// Adjustable.
constexpr std::size_t kLeastBlock = 64;

/// Relative tolerance of the height of a line at a given x, far above its rounding error of a few units in the last
/// place.
constexpr double kHeightError = 1e-12;

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
    // In a run of equal corners only the first one counts.
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
  // Two roundings in the factors of each product, and one each in product, difference and sum over n terms, to first
  // order.
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

EdgeCutter::EdgeCutter(const std::vector<Point2>& positions)
    : positions_(positions),
      block_size_(std::max<std::size_t>(kLeastBlock, std::lround(std::sqrt(static_cast<double>(positions.size()))))),
      by_height_(positions.size()) {
  std::iota(by_height_.begin(), by_height_.end(), Index{0});
  for (std::size_t begin = 0; begin < by_height_.size(); begin += block_size_) {
    const std::size_t end = std::min(begin + block_size_, by_height_.size());
    std::sort(by_height_.begin() + static_cast<std::ptrdiff_t>(begin), by_height_.begin() + static_cast<std::ptrdiff_t>(end),
              [&](Index a, Index b) { return positions[a].y < positions[b].y; });
  }
}

void EdgeCutter::append_pieces(const SweepEdge& edge, std::vector<SweepEdge>& pieces) {
  if (edge.high - edge.low <= kLeastBlock) return ligne::append_pieces(positions_, edge, pieces);
  near_.clear();
  for (std::size_t block = edge.low / block_size_; block <= edge.high / block_size_; ++block) find_near(edge, block);
  Index from = edge.low;
  for (const Index i : near_) {
    if (orientation_sign(positions_[edge.low], positions_[edge.high], positions_[i]) != 0) continue;
    pieces.push_back({from, i, edge.winding});
    from = i;
  }
  pieces.push_back({from, edge.high, edge.winding});
}

void EdgeCutter::find_near(const SweepEdge& edge, std::size_t block) {
  const std::size_t begin = block * block_size_, end = std::min(begin + block_size_, positions_.size());
  const Point2 low = positions_[edge.low], high = positions_[edge.high];
  const auto [y_min, y_max] = std::minmax(low.y, high.y);
  double from = y_min, to = y_max;
  if (low.x < high.x) {
    const double slope = (high.y - low.y) / (high.x - low.x);
    const auto height_at = [&](double x) { return low.y + (std::clamp(x, low.x, high.x) - low.x) * slope; };
    const auto [lower, upper] = std::minmax({height_at(positions_[begin].x), height_at(positions_[end - 1].x)});
    const double slack = kHeightError * (std::abs(low.y) + std::abs(high.y));
    from = std::max(y_min, lower - slack);
    to = std::min(y_max, upper + slack);
  }
  const auto last = by_height_.begin() + static_cast<std::ptrdiff_t>(end);
  auto at = std::partition_point(by_height_.begin() + static_cast<std::ptrdiff_t>(begin), last,
                                 [&](Index i) { return positions_[i].y < from; });
  const std::size_t before = near_.size();
  for (; at != last && positions_[*at].y <= to; ++at) {
    if (*at > edge.low && *at < edge.high) near_.push_back(*at);
  }
  std::sort(near_.begin() + static_cast<std::ptrdiff_t>(before), near_.end());
}

}  // namespace ligne
