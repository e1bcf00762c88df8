#include "scene/model/topology.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "geometry/triangulate.hpp"
#include "scene/model/find_edges.hpp"

namespace ligne {
namespace {

/// The two coordinates in which the polygon is largest, ordered to keep its winding.
Point2 flatten(const Point3& p, const Point3& normal) {
  const Point3 a = glm::abs(normal);
  if (a.x >= a.y && a.x >= a.z) return normal.x > 0 ? Point2{p.y, p.z} : Point2{p.z, p.y};
  if (a.y >= a.z) return normal.y > 0 ? Point2{p.z, p.x} : Point2{p.x, p.z};
  return normal.z > 0 ? Point2{p.x, p.y} : Point2{p.y, p.x};
}

void triangulate_face(const Scene& scene, std::uint32_t face, std::vector<Triangle>& out) {
  const PolygonFaces& faces = scene.faces;
  const auto outer = faces.contour(face, 0);
  if (faces.contour_count(face) == 1 && outer.size() == 3) {
    out.push_back({{outer[0], outer[1], outer[2]}, face});
    return;
  }
  const Point3 normal = face_normal(scene, face);
  std::vector<Point2> points;
  std::vector<std::uint32_t> vertices, contour_end;
  for (std::size_t c = 0; c < faces.contour_count(face); ++c) {
    for (const std::uint32_t v : faces.contour(face, c)) {
      points.push_back(flatten(scene.vertices[v], normal));
      vertices.push_back(v);
    }
    contour_end.push_back(static_cast<std::uint32_t>(points.size()));
  }
  for (const auto& t : triangulate(points, contour_end)) {
    out.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, face});
  }
}

}  // namespace

Point3 face_normal(const Scene& scene, std::uint32_t face) {
  const auto contour = scene.faces.contour(face, 0);
  const Point3 origin = scene.vertices[contour[0]];
  Point3 sum{0, 0, 0};
  for (std::size_t k = 1; k + 1 < contour.size(); ++k) {
    sum += glm::cross(scene.vertices[contour[k]] - origin, scene.vertices[contour[k + 1]] - origin);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

std::vector<Triangle> triangulate_faces(const Scene& scene) {
  std::vector<Triangle> triangles;
  const std::size_t n = scene.faces.size();
  if (scene.faces.all_triangles()) {
    triangles = large_vector<Triangle>(n);
    const auto corners = scene.faces.corners();
    parallel_each(
        n,
        [&](std::size_t f) {
          triangles[f] = {{corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]}, static_cast<std::uint32_t>(f)};
        },
        65'536);
  } else {
    triangles.reserve(n * 2);
    for (std::uint32_t f = 0; f < n; ++f) triangulate_face(scene, f, triangles);
  }
  return triangles;
}

std::uint16_t flags_of_any(const Topology& topology) {
  // There is no early exit, so that the loop can be vectorized.
  return std::accumulate(topology.edge_flags.begin(), topology.edge_flags.end(), std::uint16_t{0}, std::bit_or<>{});
}

std::vector<std::uint32_t> edges_with(const Topology& topology, unsigned flags) {
  return indices_of_marks(topology.edge_flags, flags);
}

EdgeRange edges_of(const Topology& topology, const Object& object) {
  const auto first_from = [&topology](std::uint32_t vertex) {
    const auto at = std::ranges::lower_bound(topology.edges, vertex, {}, &Edge::v0);
    return static_cast<std::uint32_t>(at - topology.edges.begin());
  };
  return {first_from(object.vertex_begin), first_from(object.vertex_end)};
}

EdgeRange edges_up_from(const Topology& topology, std::uint32_t vertex) {
  const std::vector<std::uint32_t>& first = topology.first_edges;
  if (!first.empty()) return {first[vertex], first[vertex + 1]};
  const auto from = std::ranges::lower_bound(topology.edges, vertex, {}, &Edge::v0);
  const auto to = std::ranges::upper_bound(topology.edges, vertex, {}, &Edge::v0);
  return {static_cast<std::uint32_t>(from - topology.edges.begin()),
          static_cast<std::uint32_t>(to - topology.edges.begin())};
}

void index_edges(Topology& topology, std::size_t vertices) {
  const std::size_t n = topology.edges.size();
  topology.first_edges = large_vector<std::uint32_t>(vertices + 1);
  parallel_each(n + 1, [&](std::size_t e) {
    const std::size_t from = e > 0 ? std::size_t{topology.edges[e - 1].v0} + 1 : 0;
    const std::size_t last = e < n ? topology.edges[e].v0 : vertices;
    for (std::size_t v = from; v <= last; ++v) topology.first_edges[v] = static_cast<std::uint32_t>(e);
  });
}

const Edge* find_edge(const Topology& topology, std::pair<std::uint32_t, std::uint32_t> ends) {
  const auto key_of = [](std::uint32_t low, std::uint32_t high) { return std::uint64_t{low} << 32 | high; };
  const auto [low, high] = std::minmax(ends.first, ends.second);
  const std::uint64_t key = key_of(low, high);
  const std::vector<std::uint32_t>& first = topology.first_edges;
  const Edge* at = topology.edges.data() + (first.empty() ? 0 : first[low]);
  std::size_t count = first.empty() ? topology.edges.size() : first[low + 1] - first[low];
  // A binary search without branches.
  while (count > 1) {
    const std::size_t half = count / 2;
    const Edge& middle = at[half];
    at = key_of(middle.v0, middle.v1) <= key ? at + half : at;
    count -= half;
  }
  return count == 1 && at->v0 == low && at->v1 == high ? at : nullptr;
}

Topology build_topology(const Scene& scene) {
  Topology topology;
  find_edges(scene, topology);
  topology.triangles = triangulate_faces(scene);
  return topology;
}

}  // namespace ligne
