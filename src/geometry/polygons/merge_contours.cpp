#include "geometry/polygons/merge_contours.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "base/index_lists.hpp"

namespace ligne {
namespace {

struct Edge {
  std::uint32_t from, to;  ///< numbers of points
  std::uint32_t next;      ///< edge that follows in the contour
  bool is_left = true;     ///< not yet part of a result, nor removed
  auto ends() const { return std::minmax(from, to); }
};

/// The edges of all contours; equal points have one number.
std::vector<Edge> numbered_edges(const std::vector<std::vector<Point2>>& contours, std::vector<Point2>& points) {
  std::vector<Edge> edges;
  std::vector<Point2> corners;
  for (const std::vector<Point2>& contour : contours) {
    const auto first = static_cast<std::uint32_t>(edges.size());
    for (const Point2 p : contour) {
      corners.push_back(p);
      edges.push_back({0, 0, static_cast<std::uint32_t>(edges.size()) + 1});
    }
    if (!contour.empty()) edges.back().next = first;
  }
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(corners[i].x, corners[i].y, i); });
  for (const std::uint32_t i : order) {
    if (points.empty() || points.back() != corners[i]) points.push_back(corners[i]);
    edges[i].from = static_cast<std::uint32_t>(points.size() - 1);
  }
  for (Edge& e : edges) e.to = edges[e.next].from;
  return edges;
}

/// Removes edges without length, and edges in pairs that have the same ends.
void remove_pairs(std::vector<Edge>& edges, std::size_t points) {
  IndexLists at = numbers_by_key(points, edges.size(), [&](std::uint32_t i) { return edges[i].ends().first; });
  const auto other_end = [&](std::uint32_t i) { return edges[i].ends().second; };
  for (std::uint32_t p = 0; p < points; ++p) {
    std::ranges::stable_sort(at[p], {}, other_end);
    for (std::size_t k = 0; k < at[p].size(); ++k) {
      const std::uint32_t i = at[p][k];
      if (other_end(i) == p) {
        edges[i].is_left = false;
      } else if (k + 1 < at[p].size() && other_end(at[p][k + 1]) == other_end(i)) {
        edges[i].is_left = edges[at[p][++k]].is_left = false;
      }
    }
  }
}

}  // namespace

std::vector<std::vector<Point2>> merge_contours(const std::vector<std::vector<Point2>>& contours) {
  std::vector<Point2> points;
  std::vector<Edge> edges = numbered_edges(contours, points);
  remove_pairs(edges, points.size());
  // At each point, edges that leave it come first. An even number of edges is left there, so every walk returns.
  IndexLists at(points.size(), [&](const auto& add) {
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (edges[i].is_left) add(edges[i].from, i);
    }
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (edges[i].is_left) add(edges[i].to, i);
    }
  });
  std::vector<std::uint32_t> passed(points.size(), 0);  // edges at the head of the list that are no longer left
  std::vector<std::vector<Point2>> merged;
  for (std::uint32_t first = 0; first < edges.size(); ++first) {
    if (!edges[first].is_left) continue;
    std::vector<Point2>& contour = merged.emplace_back();
    const std::uint32_t start = edges[first].from;
    for (std::uint32_t edge = first, point = start;;) {
      contour.push_back(points[point]);
      edges[edge].is_left = false;
      point = edges[edge].from == point ? edges[edge].to : edges[edge].from;
      if (edges[edge].to == point && edges[edges[edge].next].is_left) {
        edge = edges[edge].next;
        continue;
      }
      if (point == start) break;
      while (!edges[at[point][passed[point]]].is_left) ++passed[point];
      edge = at[point][passed[point]];
    }
  }
  return merged;
}

}  // namespace ligne
