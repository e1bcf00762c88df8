#include "scene/creases/face_normals.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "scene/model/flat_faces.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Largest number of slivers passed on the way to a face that has a normal. Adjustable.
constexpr int kLongestChain = 8;

/// Returns face_normal(), or zero for slivers.
Point3 own_normal(const Scene& scene, const Object& object, std::uint32_t f) {
  const auto contour = scene.faces.contour(f, 0);
  if (contour.size() != 3) return face_normal(scene, f);
  const Point3 &a = scene.vertices[contour[0]], &b = scene.vertices[contour[1]], &c = scene.vertices[contour[2]];
  const Point3 ab = b - a, ac = c - a, bc = c - b;
  const Point3 area = glm::cross(ab, ac);
  const double longest = std::sqrt(std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ac, ac)}));
  const double length = glm::length(area);
  return length <= straightness_tolerance(object.precision, longest) * longest ? Point3{0, 0, 0} : area / length;
}

/// Gives faces without a normal that of their neighbour across their longest edge. If everything around is thinner than
/// the precision, as in terrain whose eastings were written with six digits, the faces keep their own normals, since
/// there are no better ones.
void take_from_neighbours(const Scene& scene, const Topology& topology, std::vector<glm::vec3>& normals) {
  std::vector<std::uint8_t> flat(normals.size());
  for (std::size_t f = 0; f < normals.size(); ++f) flat[f] = normals[f] == glm::vec3{0, 0, 0};
  const auto neighbours = longest_neighbours(scene, topology, flat, FlatNeighbours::taken);
  std::vector<std::pair<std::uint32_t, glm::vec3>> taken;
  for (const auto& [face, first] : neighbours) {
    bool turned = false, found = false;
    LongestNeighbour next = first;
    for (int k = 0; k < kLongestChain; ++k) {
      turned ^= next.turned;
      if (!flat[next.face]) {
        taken.emplace_back(face, turned ? -normals[next.face] : normals[next.face]);
        found = true;
        break;
      }
      const auto further = neighbours.find(next.face);
      if (further == neighbours.end()) break;
      next = further->second;
    }
    if (!found) taken.emplace_back(face, face_normal(scene, face));
  }
  for (const auto& [face, normal] : taken) normals[face] = normal;
}

}  // namespace

std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology) {
  std::vector<glm::vec3> normals = large_vector<glm::vec3>(scene.faces.size());
  std::atomic<bool> any_without{false};
  const bool all_triangles = scene.faces.all_triangles();
  for (const Object& object : scene.objects) {
    const std::size_t count = object.face_end - object.face_begin;
    parallel_blocks(count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      bool without = false;
      for (std::size_t k = begin; k < end; ++k) {
        const auto f = static_cast<std::uint32_t>(object.face_begin + k);
        if (all_triangles) prefetch_corners(scene.vertices, scene.faces.corners(), f);
        normals[f] = own_normal(scene, object, f);
        without = without || normals[f] == glm::vec3{0, 0, 0};
      }
      if (without) any_without.store(true, std::memory_order_relaxed);
    });
  }
  if (any_without) take_from_neighbours(scene, topology, normals);
  return normals;
}

}  // namespace ligne
