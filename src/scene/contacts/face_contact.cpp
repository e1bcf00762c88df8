#include "scene/contacts/face_contact.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/model/topology.hpp"

namespace ligne {
namespace {

struct Extent {
  double low = 0, high = 0;
};

Extent extent(const Scene& scene, std::uint32_t face, const Point3& origin, const Point3& direction) {
  Extent e;
  for (const std::uint32_t v : scene.faces.contour(face, 0)) {
    const double at = glm::dot(scene.vertices[v] - origin, direction);
    e.low = std::min(e.low, at);
    e.high = std::max(e.high, at);
  }
  return e;
}

}  // namespace

double object_precision(const Scene& scene, std::uint32_t face) {
  const auto after = std::upper_bound(scene.objects.begin(), scene.objects.end(), face,
                                      [](std::uint32_t f, const Object& o) { return f < o.face_begin; });
  return after[-1].precision;
}

bool within_distance(const Scene& scene, const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment,
                     double distance) {
  const Point3 n = face_normal(scene, faces[0]), m = face_normal(scene, faces[1]);
  const Point3 line = glm::cross(n, m);
  const double sine = glm::length(line);
  if (sine == 0) return true;  // parallel planes that meet
  // Directions in the two faces, away from the segment and to the same side of it.
  const Point3 along_n = glm::cross(line / sine, n);
  Point3 along_m = glm::cross(line / sine, m);
  if (glm::dot(along_n, along_m) < 0) along_m = -along_m;
  const Extent a = extent(scene, faces[0], segment[0], along_n), b = extent(scene, faces[1], segment[0], along_m);
  const double width = std::max(std::min(a.high, b.high), std::min(-a.low, -b.low));
  return width * sine <= distance;
}

}  // namespace ligne
