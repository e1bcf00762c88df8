#include "scene/patches/refine/bodies_apart.hpp"

#include <vector>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Adjustable: number of bodies from which on a scene is not looked at. All pairs of boxes are compared.
constexpr std::size_t kMostBodies = 64;

struct Box {
  Point3 low{1e300}, high{-1e300};

  bool meets(const Box& other) const {
    return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high));
  }
};

}  // namespace

bool bodies_lie_apart(const Scene& scene, const Topology& topology) {
  DisjointSets bodies(scene.faces.size());
  for (const Edge& edge : topology.edges) {
    if (edge.face1 != kNone) bodies.join(edge.face0, edge.face1);
  }
  std::vector<std::uint32_t> number(scene.faces.size(), kNone);
  std::vector<Box> boxes;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    std::uint32_t& n = number[bodies.find(f)];
    if (n == kNone) {
      if (boxes.size() == kMostBodies) return false;
      n = static_cast<std::uint32_t>(boxes.size());
      boxes.emplace_back();
    }
    for (const std::uint32_t v : scene.faces.contour(f, 0)) {
      boxes[n].low = glm::min(boxes[n].low, scene.vertices[v]);
      boxes[n].high = glm::max(boxes[n].high, scene.vertices[v]);
    }
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (boxes[i].meets(boxes[k])) return false;
    }
  }
  return true;
}

}  // namespace ligne
