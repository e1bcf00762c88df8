// Masks: smooth vertices of the Catmull-Clark scheme by [CatmullClark1978], their limits by [HalsteadEtAl1993]; those
// of Loop's scheme by [Loop1987]; creases, corners and semi-sharp creases of both by [DeRoseEtAl1998], as cubic
// B-splines. The weights of every mask add up to 1, so moving the mesh moves the surface with it.

#include "scene/subdivision/masks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"

namespace ligne {
namespace {

/// The corners at each vertex, in ascending order.
IndexLists corners_at_vertices(const SubdivisionMesh& mesh) {
  return IndexLists(mesh.points.size(), [&](const auto& add) {
    for (std::uint32_t k = 0; k < mesh.corners.size(); ++k) add(mesh.corners[k], k);
  });
}

Point3 between(const Point3& a, const Point3& b, double part_of_b) { return a * (1 - part_of_b) + b * part_of_b; }

/// Twice the sum of the neighbours of the vertex of the corners, since each edge is a side of two faces.
Point3 sum_of_neighbours(const SubdivisionMesh& mesh, std::span<const std::uint32_t> star) {
  Point3 sum{0, 0, 0};
  for (const std::uint32_t k : star) {
    sum += mesh.points[mesh.corners[mesh.next(k)]] + mesh.points[mesh.corners[mesh.previous(k)]];
  }
  return sum / 2.0;
}

/// Weight of each of n neighbours of a smooth vertex in Loop's scheme.
double loop_weight(double n) {
  const double inner = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
  return (5.0 / 8 - inner * inner) / n;
}

/// A vertex on sharp edges, or a sharp vertex.
class SharpVertex {
 public:
  SharpVertex(const SubdivisionMesh& mesh, std::uint32_t vertex,
              std::span<const std::pair<std::uint32_t, std::uint32_t>> edges)
      : mesh_(mesh), vertex_(vertex), edges_(edges) {}

  /// New position of the vertex, given its position under the smooth rule, and the weight of the vertex itself on a
  /// crease. If its rule changes because edges are no longer sharp at the next level, it is interpolated between both
  /// rules by the remaining sharpness of these edges.
  Point3 place(const Point3& smooth, double crease_weight) const {
    const Point3 now = by_rule(0, smooth, crease_weight);
    double left = 0;
    int ending = 0;
    const auto count = [&](float sharpness) {
      if (!(sharpness > 0 && sharpness <= 1)) return;
      left += sharpness;
      ++ending;
    };
    count(mesh_.vertex_sharpness[vertex_]);
    for (const auto& [v, e] : edges_) {
      if (e != kNone) count(mesh_.edge_sharpness[e]);
    }
    return ending == 0 ? now : between(by_rule(1, smooth, crease_weight), now, left / ending);
  }

 private:
  /// The rule that follows from sharpness above `least`.
  Point3 by_rule(float least, const Point3& smooth, double crease_weight) const {
    const Point3& p = mesh_.points[vertex_];
    if (mesh_.vertex_sharpness[vertex_] > least) return p;
    Point3 ends{0, 0, 0};
    int sharp = 0;
    for (const auto& [v, e] : edges_) {
      if (e == kNone || !(mesh_.edge_sharpness[e] > least)) continue;
      const auto& [a, b] = mesh_.edges[e].ends;
      ends += mesh_.points[a == vertex_ ? b : a];
      ++sharp;
    }
    if (sharp < 2) return smooth;
    return sharp > 2 ? p : between(ends / 2.0, p, crease_weight);
  }

  const SubdivisionMesh& mesh_;
  std::uint32_t vertex_;
  std::span<const std::pair<std::uint32_t, std::uint32_t>> edges_;
};

/// Corrects the positions of the vertices that are not smooth.
void place_sharp_vertices(const SubdivisionMesh& mesh, double crease_weight, std::vector<Point3>& placed) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // a vertex, and a sharp edge at it or kNone
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.edge_sharpness[e] == 0) continue;
    for (const std::uint32_t v : mesh.edges[e].ends) ends.emplace_back(v, e);
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.vertex_sharpness[v] > 0) ends.emplace_back(v, kNone);
  }
  parallel_sort(ends.begin(), ends.end());
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    while (last < ends.size() && ends[last].first == ends[first].first) ++last;
    const std::uint32_t v = ends[first].first;
    placed[v] = SharpVertex(mesh, v, std::span(ends).subspan(first, last - first)).place(placed[v], crease_weight);
  }
}

Point3 centroid(const SubdivisionMesh& mesh, std::uint32_t f) {
  Point3 sum{0, 0, 0};
  for (std::uint32_t k = mesh.begin_of(f); k < mesh.end_of(f); ++k) sum += mesh.points[mesh.corners[k]];
  return sum / static_cast<double>(mesh.end_of(f) - mesh.begin_of(f));
}

Point3 smooth_vertex(const SubdivisionMesh& mesh, std::uint32_t v, std::span<const std::uint32_t> star, bool loop,
                     const std::vector<Point3>& face_points) {
  const auto n = static_cast<double>(star.size());
  const Point3 neighbours = sum_of_neighbours(mesh, star);
  if (loop) {
    const double weight = loop_weight(n);
    return mesh.points[v] * (1 - n * weight) + neighbours * weight;
  }
  Point3 faces{0, 0, 0};
  for (const std::uint32_t k : star) faces += face_points[mesh.face_of(k)];
  return (mesh.points[v] * (n * (n - 2)) + neighbours + faces) / (n * n);
}

Point3 smooth_limit(const SubdivisionMesh& mesh, std::uint32_t v, std::span<const std::uint32_t> star, bool loop) {
  const auto n = static_cast<double>(star.size());
  const Point3 neighbours = sum_of_neighbours(mesh, star);
  if (loop) {
    const double weight = 1 / (3 / (8 * loop_weight(n)) + n);
    return mesh.points[v] * (1 - n * weight) + neighbours * weight;
  }
  Point3 opposite{0, 0, 0};
  for (const std::uint32_t k : star) opposite += mesh.points[mesh.corners[(k & ~3u) | ((k + 2) & 3u)]];
  return (mesh.points[v] * (n * n) + neighbours * 4.0 + opposite) / (n * (n + 5));
}

Point3 edge_point(const SubdivisionMesh& mesh, std::uint32_t e, bool loop, const std::vector<Point3>& face_points) {
  const SubdivisionEdge& edge = mesh.edges[e];
  const Point3 sum = mesh.points[edge.ends[0]] + mesh.points[edge.ends[1]], middle = sum / 2.0;
  const double sharpness = mesh.edge_sharpness[e];
  if (sharpness >= 1) return middle;
  Point3 smooth;
  if (loop) {
    const auto opposite = [&](std::uint32_t side) { return mesh.points[mesh.corners[mesh.previous(side)]]; };
    smooth = (sum * 3.0 + opposite(edge.sides[0]) + opposite(edge.sides[1])) / 8.0;
  } else {
    smooth = (sum + face_points[mesh.face_of(edge.sides[0])] + face_points[mesh.face_of(edge.sides[1])]) / 4.0;
  }
  return sharpness > 0 ? between(smooth, middle, sharpness) : smooth;
}

}  // namespace

std::vector<Point3> refined_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme) {
  constexpr double kCreaseWeight = 3.0 / 4;
  const bool loop = scheme == SubdivisionScheme::loop;
  std::vector<Point3> face_points(loop ? 0 : mesh.face_count());
  parallel_each(face_points.size(), [&](std::uint32_t f) { face_points[f] = centroid(mesh, f); });
  const IndexLists stars = corners_at_vertices(mesh);
  const std::size_t vertices = mesh.points.size(), edges = mesh.edges.size();
  std::vector<Point3> points(vertices + edges + face_points.size());
  parallel_each(vertices, [&](std::uint32_t v) { points[v] = smooth_vertex(mesh, v, stars[v], loop, face_points); });
  place_sharp_vertices(mesh, kCreaseWeight, points);
  parallel_each(edges, [&](std::uint32_t e) { points[vertices + e] = edge_point(mesh, e, loop, face_points); });
  std::ranges::copy(face_points, points.begin() + static_cast<std::ptrdiff_t>(vertices + edges));
  return points;
}

std::vector<Point3> limit_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme) {
  constexpr double kCreaseWeight = 2.0 / 3;
  const bool loop = scheme == SubdivisionScheme::loop;
  const IndexLists stars = corners_at_vertices(mesh);
  std::vector<Point3> points(mesh.points.size());
  parallel_each(points.size(), [&](std::uint32_t v) { points[v] = smooth_limit(mesh, v, stars[v], loop); });
  place_sharp_vertices(mesh, kCreaseWeight, points);
  return points;
}

}  // namespace ligne
