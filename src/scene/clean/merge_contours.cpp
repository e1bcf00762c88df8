#include "scene/clean/merge_contours.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <unordered_map>

namespace ligne {
namespace {

/// Walks along edges to form simple contours.
class BoundaryWalk {
 public:
  BoundaryWalk(const std::vector<Point3>& vertices, const PlaneAxes& axes, std::vector<BoundaryEdge> edges)
      : vertices_(vertices), axes_(axes), edges_(std::move(edges)), used_(edges_.size(), 0) {
    std::sort(edges_.begin(), edges_.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
  }

  std::vector<Contour> run() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!used_[e]) walk(e);
    }
    return std::move(contours_);
  }

 private:
  /// Walks from one edge until the path is used up. Invariant: no vertex begins two edges of the path.
  void walk(std::size_t edge) {
    for (;;) {
      used_[edge] = 1;
      place_[edges_[edge].from] = path_.size();
      path_.push_back(edge);
      const std::uint32_t at = edges_[edge].to;
      if (const auto met = place_.find(at); met != place_.end()) cut(met->second);
      if (path_.empty()) return;
      edge = next_edge(at);
    }
  }

  /// Cuts off the end of the path from `begin` on as a contour.
  void cut(std::size_t begin) {
    Contour contour;
    for (const std::size_t e : std::span(path_).subspan(begin)) {
      contour.corners.push_back(edges_[e].from);
      contour.flags.push_back(edges_[e].flags);
      place_.erase(edges_[e].from);
    }
    path_.resize(begin);
    if (contour.corners.size() >= 3) contours_.push_back(std::move(contour));
  }

  /// Among the edges that leave `at`, the first one clockwise from the edge by which the path arrives: the region lies
  /// between the two.
  std::size_t next_edge(std::uint32_t at) const {
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), at,
                                        [](const BoundaryEdge& e, std::uint32_t v) { return e.from < v; });
    const Point2 here = axes_(vertices_[at]);
    const Point2 back = axes_(vertices_[edges_[path_.back()].from]) - here;
    std::size_t best = 0;
    double best_angle = std::numeric_limits<double>::infinity();
    for (auto it = first; it != edges_.end() && it->from == at; ++it) {
      const auto e = static_cast<std::size_t>(it - edges_.begin());
      if (used_[e]) continue;
      const Point2 ahead = axes_(vertices_[it->to]) - here;
      double angle = std::atan2(-cross(back, ahead), glm::dot(back, ahead));
      if (angle <= 0) angle += 2 * std::numbers::pi;
      if (angle < best_angle) best_angle = angle, best = e;
    }
    return best;
  }

  const std::vector<Point3>& vertices_;
  const PlaneAxes& axes_;
  std::vector<BoundaryEdge> edges_;  ///< by start vertex
  std::vector<std::uint8_t> used_;
  std::vector<std::size_t> path_;                         ///< edges, each starting where the one before ends
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< per vertex: index of the path edge from it
  std::vector<Contour> contours_;
};

double signed_area(const std::vector<Point3>& vertices, const PlaneAxes& axes, const Contour& contour) {
  const Point2 origin = axes(vertices[contour.corners[0]]);
  double sum = 0;
  for (std::size_t i = 1; i + 1 < contour.corners.size(); ++i) {
    sum += cross(axes(vertices[contour.corners[i]]) - origin, axes(vertices[contour.corners[i + 1]]) - origin);
  }
  return sum / 2;
}

/// A point of a hole that decides whether an outer contour surrounds it: a vertex that they do not share, or the middle
/// of an edge.
Point2 probe(const std::vector<Point3>& vertices, const PlaneAxes& axes, const Contour& hole, const Contour& outer) {
  std::vector<std::uint32_t> shared = outer.corners;
  std::sort(shared.begin(), shared.end());
  for (const std::uint32_t v : hole.corners) {
    if (!std::binary_search(shared.begin(), shared.end(), v)) return axes(vertices[v]);
  }
  return (axes(vertices[hole.corners[0]]) + axes(vertices[hole.corners[1]])) * 0.5;
}

}  // namespace

PlaneAxes PlaneAxes::facing(const Point3& normal) {
  const Point3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  PlaneAxes axes{(axis + 1) % 3, (axis + 2) % 3};
  if (normal[axis] < 0) std::swap(axes.right, axes.up);
  return axes;
}

bool is_inside(const std::vector<Point3>& vertices, const PlaneAxes& axes, const Contour& contour, Point2 p) {
  bool inside = false;
  Point2 a = axes(vertices[contour.corners.back()]);
  for (const std::uint32_t v : contour.corners) {
    const Point2 b = axes(vertices[v]);
    if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    a = b;
  }
  return inside;
}

std::vector<MergedFace> faces_of_boundary(const std::vector<Point3>& vertices, const PlaneAxes& axes,
                                          std::vector<BoundaryEdge> edges) {
  std::vector<MergedFace> faces;
  std::vector<Contour> holes;
  std::vector<double> areas;
  for (Contour& contour : BoundaryWalk(vertices, axes, std::move(edges)).run()) {
    const double area = signed_area(vertices, axes, contour);
    if (area < 0) {
      holes.push_back(std::move(contour));
    } else {
      faces.push_back({0, true, {}});
      faces.back().contours.push_back(std::move(contour));
      areas.push_back(area);
    }
  }
  if (faces.empty()) return faces;
  for (Contour& hole : holes) {
    // Takes the smallest contour around it. If rounding leaves none, only the largest contour of all can be the right
    // one.
    std::size_t best = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    for (std::size_t f = 0; f < faces.size() && faces.size() > 1; ++f) {
      const Contour& outer = faces[f].contours[0];
      if (areas[f] < areas[best] && is_inside(vertices, axes, outer, probe(vertices, axes, hole, outer))) best = f;
    }
    faces[best].contours.push_back(std::move(hole));
  }
  return faces;
}

}  // namespace ligne
