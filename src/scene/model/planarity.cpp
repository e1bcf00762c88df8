#include "scene/model/planarity.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ligne {
double SpanningPlane::distance(const Point3& q) const { return glm::dot(q - origin, normal); }

SpanningPlane spanning_plane(std::span<const Point3> points) {
  SpanningPlane plane;
  if (points.empty()) return plane;
  const Point3 a = points.front();
  Point3 ab(0), ac(0);
  double longest = 0;
  for (const Point3& q : points) {
    const double square = glm::dot(q - a, q - a);
    if (square > longest) longest = square, ab = q - a;
  }
  plane.origin = a;
  if (longest == 0) return plane;
  plane.span = std::sqrt(longest);
  const Point3 u = ab / plane.span;
  double farthest = 0;
  for (const Point3& q : points) {
    // Gram-Schmidt, so that the error stays that of the coordinates however slender the polygon is.
    const Point3 off = (q - a) - u * glm::dot(q - a, u);
    const double square = glm::dot(off, off);
    if (square > farthest) farthest = square, ac = off;
  }
  if (farthest > 0) plane.normal = glm::normalize(glm::cross(u, ac / std::sqrt(farthest)));
  return plane;
}

bool is_sliver(const Point3& a, const Point3& b, const Point3& c, double precision) {
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  return glm::length(glm::cross(b - a, c - a)) <= straightness_tolerance(precision, longest) * longest;
}

bool is_sliver_face(const Scene& scene, std::uint32_t face) {
  const auto corners = scene.faces.contour(face, 0);
  if (scene.faces.contour_count(face) != 1 || corners.size() != 3) return false;
  const double precision = std::ranges::upper_bound(scene.objects, face, {}, &Object::face_end)->precision;
  const auto& at = scene.vertices;
  return is_sliver(at[corners[0]], at[corners[1]], at[corners[2]], precision);
}

Point3 area_vector(const std::vector<Point3>& vertices, std::span<const std::uint32_t> contour) {
  const Point3 a = vertices[contour[0]];
  Point3 sum(0);
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    sum += glm::cross(vertices[contour[i]] - a, vertices[contour[i + 1]] - a);
  }
  return 0.5 * sum;
}

}  // namespace ligne
