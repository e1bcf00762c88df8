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
  begin_.assign(count + 2, 0);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : corners_of(scene.faces, f)) ++begin_[number_[v - first_vertex_] + 1];
  }
  begin_[1] = 0;  // drops the count of vertices not requested
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  uses_.resize(begin_.back());
  std::vector<std::uint32_t> next = begin_;
  for (const std::uint32_t f : faces) {
    const bool triangle = is_triangle(scene.faces, f);
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      const std::size_t n = contour.size();
      for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t number = number_[contour[k] - first_vertex_];
        if (number == 0) continue;
        uses_[next[number]++] = {contour[k], contour[k == 0 ? n - 1 : k - 1], contour[k + 1 == n ? 0 : k + 1], f, triangle};
      }
    }
  }
}

std::span<const CornerUse> CornerUses::of(std::uint32_t v) const {
  const std::uint32_t number = number_[v - first_vertex_];
  return {uses_.data() + begin_[number], uses_.data() + begin_[number + 1]};
}

bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after, double precision) {
  const Point3 side = after - before, normal = glm::cross(side, p - before);
  if (glm::dot(normal, glm::cross(side, q - before)) > 0) return false;
  const bool is_needle =
      glm::length(normal) <= kNeedlePart * std::max(glm::dot(side, side), glm::dot(p - before, p - before));
  return !is_needle || !is_sliver(p, before, after, precision);
}

}  // namespace ligne
