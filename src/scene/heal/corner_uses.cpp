#include "scene/heal/corner_uses.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Adjustable. Largest ratio of height and length of a needle. Where the precision is as coarse as the mesh, all triangles
/// are slivers, and those that are no needles keep their sides.
constexpr double kNeedlePart = 1e-3;

}  // namespace

CornerUses::CornerUses(const Scene& scene, const Object& object, std::span<const std::uint32_t> faces,
                       const std::vector<std::uint32_t>& vertices)
    : first_vertex_(object.vertex_begin), number_(object.vertex_end - object.vertex_begin, 0) {
  std::uint32_t count = 0;
  for (const std::uint32_t v : vertices) {
    std::uint32_t& number = number_[v - first_vertex_];
    if (number == 0) number = ++count;
  }
  const auto add_uses = [&](const auto& put) {
    for (const std::uint32_t f : faces) {
      const bool triangle = is_triangle(scene.faces, f);
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        const auto contour = scene.faces.contour(f, c);
        const std::size_t n = contour.size();
        for (std::size_t k = 0; k < n; ++k) {
          const std::uint32_t number = number_[contour[k] - first_vertex_];
          if (number == 0) continue;
          put(number, CornerUse{contour[k], contour[k == 0 ? n - 1 : k - 1], contour[k + 1 == n ? 0 : k + 1], f, triangle});
        }
      }
    }
  };
  uses_ = {count + std::size_t{1}, add_uses};
}

bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after, double precision) {
  const Point3 side = after - before, normal = glm::cross(side, p - before);
  if (glm::dot(normal, glm::cross(side, q - before)) > 0) return false;
  const bool is_needle =
      glm::length(normal) <= kNeedlePart * std::max(glm::dot(side, side), glm::dot(p - before, p - before));
  return !is_needle || !is_sliver(p, before, after, precision);
}

}  // namespace ligne
