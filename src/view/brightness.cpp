#include "view/brightness.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "scene/topology.hpp"

namespace ligne {

std::vector<double> face_brightness(const Scene& scene, const Camera& camera) {
  std::vector<double> result(scene.faces.size(), 0);
  double largest = 0;
  for (std::uint32_t f = 0; f < result.size(); ++f) {
    const Point3 normal = face_normal(scene, f);
    if (!camera.perspective) {
      const double cosine = glm::dot(normal, camera.forward);
      result[f] = cosine * cosine;
    } else {
      const auto contour = scene.faces.contour(f, 0);
      Point3 middle{0, 0, 0};
      for (const std::uint32_t v : contour) middle += scene.vertices[v];
      middle /= double(contour.size());
      const Point3 sight = middle - camera.eye;
      const double square = glm::dot(sight, sight);
      if (!(square > 0) || glm::dot(sight, camera.forward) <= 0) continue;
      const double cosine = glm::dot(normal, sight);
      result[f] = cosine * cosine / (square * square);  // the sight is not of unit length
    }
    largest = std::max(largest, result[f]);
  }
  for (double& b : result) b = largest > 0 ? b / largest : 1;
  return result;
}

}  // namespace ligne
