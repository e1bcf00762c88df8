#include "visibility/newell/separated_cells.hpp"

#include <cmath>

namespace ligne::newell {

// The first plane divides the scene, the second divides both sides, and so on: the first plane sets the highest bit.
std::vector<std::uint32_t> separated_cells(const Scene& scene, const Viewpoint& viewpoint) {
  const std::vector<SeparatingPlane>& planes = scene.stated.planes;
  if (planes.empty()) return {};
  std::vector<std::uint32_t> cell(scene.faces.size(), 0);
  for (const Object& object : scene.objects) {
    std::uint32_t number = 0;
    for (const SeparatingPlane& stated : planes) {
      const ModelPlane plane{stated.normal, stated.point};
      double farthest = 0;
      for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
        const double height = plane.height(scene.vertices[v]);
        if (std::abs(height) > std::abs(farthest)) farthest = height;
      }
      number = number << 1 | ((farthest > 0) == viewpoint.in_front_of(plane) ? 1u : 0u);
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) cell[f] = number;
  }
  return cell;
}

}  // namespace ligne::newell
