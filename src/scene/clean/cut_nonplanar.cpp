#include "scene/clean/cut_nonplanar.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/triangulate.hpp"
#include "scene/model/planarity.hpp"
#include "scene/model/scene.hpp"

namespace ligne {
namespace {

std::vector<Point3> corner_points(const std::vector<Point3>& vertices, const DetachedFace& face) {
  std::vector<Point3> points;
  points.reserve(face.corners.size());
  for (const std::uint32_t v : face.corners) points.push_back(vertices[v]);
  return points;
}

/// Projects along the axis in which `normal` is largest. Keeps the winding seen from the tip of `normal`.
std::vector<Point2> project(std::span<const Point3> points, const Point3& normal) {
  const Point3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  int right = (axis + 1) % 3, up = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(right, up);
  std::vector<Point2> flat;
  flat.reserve(points.size());
  for (const Point3& p : points) flat.emplace_back(p[right], p[up]);
  return flat;
}

/// Index of the next corner on the contour, per corner.
std::vector<std::uint32_t> successors(const DetachedFace& face) {
  std::vector<std::uint32_t> next(face.corners.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t end : face.contour_end) {
    for (std::uint32_t k = begin; k < end; ++k) next[k] = k + 1 == end ? begin : k + 1;
    begin = end;
  }
  return next;
}

}  // namespace

bool is_planar(const std::vector<Point3>& vertices, const DetachedFace& face, double precision) {
  if (face.corners.size() == 3) return true;
  const std::vector<Point3> points = corner_points(vertices, face);
  const SpanningPlane plane = spanning_plane(points);
  const double tolerance = planarity_tolerance(precision, plane.span);
  return std::ranges::all_of(points, [&](const Point3& p) { return std::abs(plane.distance(p)) <= tolerance; });
}

bool is_covered(const std::vector<Point3>& vertices, const DetachedFace& face) {
  if (face.corners.size() == 3) return true;
  // Not along the area vector, which can vanish if parts are wound in opposite directions.
  const std::vector<Point3> points = corner_points(vertices, face);
  return triangles_are_whole(project(points, spanning_plane(points).normal), face.contour_end);
}

std::vector<CutTriangle> cut_into_triangles(const std::vector<Point3>& vertices, const DetachedFace& face, bool& covered) {
  const std::vector<Point3> points = corner_points(vertices, face);
  Point3 normal = area_vector(vertices, std::span(face.corners).first(face.contour_end[0]));
  if (normal == Point3(0)) normal = spanning_plane(points).normal;
  const std::vector<std::uint32_t> next = successors(face);
  // A hole may be wound like the outer contour; its edges then run opposite to those of the triangles.
  const auto flags_of_edge = [&](std::uint32_t from, std::uint32_t to) -> std::uint8_t {
    if (next[from] == to) return face.flags[from];
    if (next[to] == from) return face.flags[to];
    return kCornerInner;
  };
  std::vector<CutTriangle> triangles;
  for (const auto& [a, b, c] : triangulate(project(points, normal), face.contour_end, &covered)) {
    const auto& v = face.corners;
    if (v[a] == v[b] || v[b] == v[c] || v[c] == v[a]) continue;
    triangles.push_back({{v[a], v[b], v[c]}, {flags_of_edge(a, b), flags_of_edge(b, c), flags_of_edge(c, a)}});
  }
  return triangles;
}

}  // namespace ligne
