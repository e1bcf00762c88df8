#include "view/axes/axis_edges.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/clip.hpp"

namespace ligne {
namespace {

/// Largest distance of a corner from the line of an edge on which it counts as lying, in mm: the accuracy of the
/// drawing.
constexpr double kOnLineMm = 1e-3;

// Shortest axis, and largest distance of two axes that count as collinear, in text heights. Adjustable.
constexpr double kShortest = 2;
constexpr double kSameLine = 3;
constexpr double kSameDirection = 0.35;  ///< sine of the largest angle between collinear axes

// Costs of a choice, in diagonals of the picture. Adjustable.
constexpr double kScaleConflictRatio = 10;  ///< two scales on one line
constexpr double kInOneLine = 0.5;          ///< the scale of heights continues another one: hard to read
constexpr double kSecondary = 1e-3;         ///< decides between edges that are equally low, or equally far left

struct Corners {
  std::array<Point2, 8> at;
  Rect extent;
  bool in_front = true;
};

Corners corners_of(const AxesBox& box, const View& view) {
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) {
    const HomogeneousPoint h = to_homogeneous(view, box.corner(i));
    if (h.w < view.near_distance) corners.in_front = false;
    corners.at[i] = {h.x / h.w, h.y / h.w};
    corners.extent.extend(corners.at[i]);
  }
  return corners;
}

/// The edge as a place for a scale, if it belongs to the outline and its visible part is long enough.
std::optional<AxisEdge> candidate(const BoxEdge& edge, const AxesBox& box, const View& view, const Corners& corners,
                                  double shortest) {
  const Point2 p = corners.at[edge.from], q = corners.at[edge.to()];
  const double length = glm::distance(p, q);
  if (!(length >= shortest)) return std::nullopt;
  const Point2 normal = Point2(q.y - p.y, p.x - q.x) / length;
  double low = 0, high = 0;
  for (const Point2 c : corners.at) {
    const double beside = glm::dot(c - p, normal);
    low = std::min(low, beside);
    high = std::max(high, beside);
  }
  if (low < -kOnLineMm && high > kOnLineMm) return std::nullopt;
  AxisEdge found{edge.axis, edge.from, p, q, high > -low ? -normal : normal};
  // If all corners are collinear, outwards is down, or else to the left.
  if (low >= -kOnLineMm && high <= kOnLineMm && (normal.y < 0 || (normal.y == 0 && normal.x > 0))) found.outward = -normal;

  const HomogeneousPoint a = to_homogeneous(view, box.corner(edge.from)), b = to_homogeneous(view, box.corner(edge.to()));
  const auto part = clip_segment(a, b, ClipVolume{view.window, view.near_distance});
  if (!part) return std::nullopt;
  const auto at = [&](double t) {
    const HomogeneousPoint h = interpolate(a, b, t);
    return Point2(h.x / h.w, h.y / h.w);
  };
  if (part->cut[0]) found.a = at(part->range[0]);
  if (part->cut[1]) found.b = at(part->range[1]);
  return glm::distance(found.a, found.b) >= shortest ? std::optional(found) : std::nullopt;
}

double cost(const AxisEdge& edge, const Rect& extent, double diagonal) {
  const Point2 middle = (edge.a + edge.b) * 0.5;
  const double from_left = (middle.x - extent.min.x) / diagonal, from_below = (extent.max.y - middle.y) / diagonal;
  return edge.axis == 2 ? from_left + kSecondary * from_below : from_below + kSecondary * from_left;
}

double cost(const AxisEdge& e, const AxisEdge& f, double height) {
  const double length = glm::distance(e.a, e.b);
  const Point2 along = (e.b - e.a) / length;
  if (std::abs(cross(along, f.b - f.a)) > kSameDirection * glm::distance(f.a, f.b)) return 0;
  for (const Point2 p : {f.a, f.b}) {
    if (std::abs(cross(along, p - e.a)) > kSameLine * height) return 0;
  }
  const double from = glm::dot(along, f.a - e.a), to = glm::dot(along, f.b - e.a);
  const double shared = std::min(length, std::max(from, to)) - std::max(0.0, std::min(from, to));
  if (shared > height) return kScaleConflictRatio;
  return f.axis == 2 ? kInOneLine : 0;
}

}  // namespace

AxisEdges choose_axis_edges(const AxesBox& box, const View& view, double text_height_mm) {
  const Corners corners = corners_of(box, view);
  if (!corners.in_front) return {};
  std::array<std::vector<std::optional<AxisEdge>>, 3> candidates;
  for (const BoxEdge& edge : box_edges()) {
    if (auto found = candidate(edge, box, view, corners, kShortest * text_height_mm)) candidates[edge.axis].push_back(found);
  }
  for (auto& list : candidates) {
    if (list.empty()) list.push_back(std::nullopt);
  }
  const double diagonal = std::hypot(corners.extent.width(), corners.extent.height());
  AxisEdges best;
  double least = 1e300;
  for (const auto& x : candidates[0]) {
    for (const auto& y : candidates[1]) {
      for (const auto& z : candidates[2]) {
        const AxisEdges choice{x, y, z};
        double sum = 0;
        for (unsigned i = 0; i < 3; ++i) {
          if (choice[i]) sum += cost(*choice[i], corners.extent, diagonal);
          for (unsigned k = i + 1; k < 3; ++k) {
            if (choice[i] && choice[k]) sum += cost(*choice[i], *choice[k], text_height_mm);
          }
        }
        // If costs are equal within rounding the first choice stays, so that equal pictures get equal choices.
        if (sum < least - kOnLineMm / std::max(diagonal, kOnLineMm)) {
          least = sum;
          best = choice;
        }
      }
    }
  }
  return best;
}

}  // namespace ligne
