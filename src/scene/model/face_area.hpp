#pragma once
/// Area of a face as a vector.

#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "scene/model/scene.hpp"

namespace ligne {

/// The normal of a face, with twice its area as length, square model units; holes are subtracted.
inline Point3 double_area(const Scene& scene, std::uint32_t face) {
  Point3 sum(0, 0, 0);
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto contour = scene.faces.contour(face, c);
    const Point3& a = scene.vertices[contour[0]];
    for (std::size_t k = 2; k < contour.size(); ++k) {
      sum += glm::cross(scene.vertices[contour[k - 1]] - a, scene.vertices[contour[k]] - a);
    }
  }
  return sum;
}

}  // namespace ligne
