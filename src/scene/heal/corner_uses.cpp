#include "scene/heal/corner_uses.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {

CornerUses::CornerUses(const Scene& scene, const Object& object, const std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint8_t> wanted(object.vertex_end - object.vertex_begin, 0);
  for (const std::uint32_t v : vertices) wanted[v - object.vertex_begin] = 1;
  const bool triangles = scene.faces.all_triangles();
  const std::uint32_t* corners = scene.faces.corners().data();
  for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
    if (triangles) {  // most faces have none of the vertices
      const std::uint32_t* v = corners + 3 * std::size_t{f};
      const auto is_wanted = [&](int k) { return wanted[v[k] - object.vertex_begin]; };
      if (!(is_wanted(0) | is_wanted(1) | is_wanted(2))) continue;
    }
    const bool triangle = scene.faces.contour_count(f) == 1 && scene.faces.contour(f, 0).size() == 3;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      const std::size_t n = contour.size();
      for (std::size_t k = 0; k < n; ++k) {
        if (!wanted[contour[k] - object.vertex_begin]) continue;
        uses_.push_back({contour[k], contour[k == 0 ? n - 1 : k - 1], contour[k + 1 == n ? 0 : k + 1], f, triangle});
      }
    }
  }
  std::stable_sort(uses_.begin(), uses_.end(), [](const CornerUse& a, const CornerUse& b) { return a.vertex < b.vertex; });
}

std::span<const CornerUse> CornerUses::of(std::uint32_t v) const {
  const auto less = [](const CornerUse& a, const CornerUse& b) { return a.vertex < b.vertex; };
  const auto [first, last] = std::equal_range(uses_.begin(), uses_.end(), CornerUse{v, 0, 0, 0, false}, less);
  return {first, last};
}

bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after) {
  const Point3 side = after - before;
  const Point3 old_normal = glm::cross(side, p - before);
  return old_normal != Point3(0) && !(glm::dot(old_normal, glm::cross(side, q - before)) > 0);
}

}  // namespace ligne
