#include "scene/model/face_shape.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/model/topology.hpp"

namespace ligne {

bool is_convex_face(const Scene& scene, std::uint32_t face, double tolerance) {
  if (scene.faces.contour_count(face) > 1) return false;
  const auto corners = scene.faces.contour(face, 0);
  const std::size_t n = corners.size();
  if (n == 3) return true;
  const Point3 normal = face_normal(scene, face);
  const auto at = [&](std::size_t i) { return scene.vertices[corners[i % n]]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 in = at(i + 1) - at(i), out = at(i + 2) - at(i + 1);
    // The turn is the length of one side times the distance of the other's end from its line.
    const double longer = std::max(glm::length(in), glm::length(out));
    if (glm::dot(normal, glm::cross(in, out)) < -tolerance * longer) return false;
  }
  return true;
}

}  // namespace ligne
