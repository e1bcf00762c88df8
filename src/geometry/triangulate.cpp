#include "geometry/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/flip_edges.hpp"
#include "geometry/polygons/contour_edges.hpp"
#include "geometry/polygons/contour_links.hpp"
#include "geometry/polygons/contour_sweep.hpp"
#include "geometry/polygons/ear_cutter.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

/// Largest number of corners of a polygon that is cut by ears without a sweep, which is as fast there. Adjustable.
constexpr std::size_t kFewCorners = 256;

/// +1 or -1 if the contour is strictly convex and winds once in that direction; otherwise 0.
int convex_sign(std::span<const Point2> c) {
  const std::size_t n = c.size();
  const int sign = orientation_sign(c[n - 1], c[0], c[1]);
  if (sign == 0) return 0;
  const auto rightward = [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 a = c[i], b = c[(i + 1) % n], d = c[(i + 2) % n];
    if (orientation_sign(a, b, d) != sign) return 0;
    changes += rightward(a, b) != rightward(b, d);
  }
  return changes == 2 ? sign : 0;
}

/// The points, scaled by a power of two if their size would take products out of the range of exact predicates.
std::vector<Point2> in_exact_range(std::span<const Point2> points) {
  constexpr int kLargestExponent = 400, kSmallestExponent = -200;
  double largest = 0;
  for (const Point2 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  std::vector<Point2> scaled(points.begin(), points.end());
  if (largest == 0) return scaled;
  const int exponent = std::ilogb(largest);
  if (exponent <= kLargestExponent && exponent >= kSmallestExponent) return scaled;
  for (Point2& p : scaled) p = {std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent)};
  return scaled;
}

bool is_finite(std::span<const Point2> points) {
  return std::all_of(points.begin(), points.end(), [](Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

struct Cut {
  std::vector<Triple> triangles;  ///< of positions, counter-clockwise
  bool whole = true;
};

/// Cuts the polygon. `slender`: edges are not flipped, so that slender triangles stay.
Cut cut(const ContourEdges& contours, bool slender) {
  SweptContours swept;
  if (contours.edges.size() <= kFewCorners) {
    swept.simple = false;
    for (const SweepEdge& edge : contours.edges) append_pieces(contours.positions, edge, swept.pieces);
  } else {
    swept = sweep_contours(contours.positions, contours.edges);
  }
  if (!swept.simple) {
    CutEars ears = cut_ears(contours.positions, link_contours(contours.positions, swept.pieces));
    return {std::move(ears.triangles), ears.whole};
  }
  if (!slender) flip_to_delaunay(contours.positions, swept.triangles);
  return {std::move(swept.triangles), true};
}

/// Whether the only contour is so small and strictly convex that a fan about its first corner suffices.
bool is_small_and_convex(std::span<const Point2> points, std::span<const std::uint32_t> contour_end) {
  return contour_end.size() == 1 && contour_end[0] <= kFewCorners && convex_sign(points.first(contour_end[0])) != 0;
}

}  // namespace

std::vector<Triple> triangulate(std::span<const Point2> points, std::span<const std::uint32_t> contour_end, bool* whole) {
  std::vector<Triple> triangles;
  if (whole) *whole = true;
  if (contour_end.empty() || contour_end[0] < 3 || !is_finite(points)) return triangles;
  const std::vector<Point2> scaled = in_exact_range(points);
  if (is_small_and_convex(scaled, contour_end)) {
    for (Index i = 1; i + 1 < contour_end[0]; ++i) triangles.push_back({0, i, i + 1});
    return triangles;
  }
  const ContourEdges contours = number_contour_edges(scaled, contour_end);
  Cut result = cut(contours, false);
  if (whole) *whole = result.whole;
  triangles = std::move(result.triangles);
  const bool clockwise = contour_sign(std::span(scaled).first(contour_end[0])) < 0;
  for (Triple& t : triangles) {
    t = {contours.source[t[0]], contours.source[t[1]], contours.source[t[2]]};
    if (clockwise) std::swap(t[1], t[2]);
  }
  return triangles;
}

bool triangles_are_whole(std::span<const Point2> points, std::span<const std::uint32_t> contour_end) {
  if (contour_end.empty() || contour_end[0] < 3 || !is_finite(points)) return true;
  const std::vector<Point2> scaled = in_exact_range(points);
  return is_small_and_convex(scaled, contour_end) || cut(number_contour_edges(scaled, contour_end), true).whole;
}

}  // namespace ligne
