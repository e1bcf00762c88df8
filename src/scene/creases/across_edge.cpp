#include "scene/creases/across_edge.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {
Point3 across_face(const Scene& scene, const Edge& edge, std::uint32_t f) {
  const Point3 a = scene.vertices[edge.v0], along = glm::normalize(scene.vertices[edge.v1] - a);
  Point3 farthest{0, 0, 0};
  for (const std::uint32_t v : scene.faces.contour(f, 0)) {
    const Point3 to = scene.vertices[v] - a;
    const Point3 across = to - glm::dot(to, along) * along;
    if (glm::dot(across, across) > glm::dot(farthest, farthest)) farthest = across;
  }
  return farthest;
}

double radius_across(const Scene& scene, const Edge& edge, double turn) {
  const double a = glm::length(across_face(scene, edge, edge.face0)), b = glm::length(across_face(scene, edge, edge.face1));
  return std::min(a, b) / turn;
}

}  // namespace ligne
