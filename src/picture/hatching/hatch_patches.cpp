#include "picture/hatching/hatch_patches.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"

namespace ligne {

HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees) {
  const std::size_t face_count = scene.faces.size();
  DisjointSets smooth(face_count);
  std::vector<Point3> normals(face_count);
  for (std::uint32_t face = 0; face < face_count; ++face) normals[face] = face_normal(scene, face);
  const double cosine = std::cos(crease_degrees * std::numbers::pi / 180);
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    const Edge& edge = topology.edges[i];
    const std::uint16_t flags = topology.edge_flags[i];
    if (edge.face0 == kNone || edge.face1 == kNone || (flags & kEdgeManyFaces)) continue;
    const double turn = glm::dot(normals[edge.face0], normals[edge.face1]);
    if ((flags & kEdgeUnlikeWound ? -turn : turn) < cosine) continue;
    smooth.join(edge.face0, edge.face1);
  }
  HatchPatches patches{std::vector<std::uint32_t>(face_count), 0};
  for (std::uint32_t face = 0; face < face_count; ++face) {
    const std::uint32_t first = smooth.find(face);
    patches.of_face[face] = first == face ? patches.count++ : patches.of_face[first];
  }
  return patches;
}

Point3 area_vector(const Scene& scene, std::uint32_t face) {
  const auto contour = scene.faces.contour(face, 0);
  Point3 area{0, 0, 0};
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    area += glm::cross(scene.vertices[contour[i]] - scene.vertices[contour[0]],
                       scene.vertices[contour[i + 1]] - scene.vertices[contour[0]]);
  }
  return area;
}

std::vector<std::optional<double>> flat_light(const Scene& scene, const HatchPatches& patches, const FaceLight& light) {
  // Cosine of one degree. Within it, the light differs by less than a third of the step between two numbers of rows.
  constexpr double kFlatCosine = 0.99985;
  struct Sum {
    Point3 normal{0, 0, 0};
    double light = 0, weight = 0;
    bool flat = true;
  };
  std::vector<Sum> sums(patches.count);
  for (std::uint32_t face = 0; face < scene.faces.size(); ++face) {
    const Point3 area = area_vector(scene, face);
    const double size = glm::length(area);
    if (!(size > 0)) continue;
    Sum& sum = sums[patches.of_face[face]];
    if (sum.weight == 0) sum.normal = area / size;
    sum.flat = sum.flat && std::abs(glm::dot(sum.normal, area)) >= kFlatCosine * size;
    sum.light += size * light.of(face);
    sum.weight += size;
  }
  std::vector<std::optional<double>> lights;
  for (const Sum& sum : sums) {
    lights.push_back(sum.flat && sum.weight > 0 ? std::optional(sum.light / sum.weight) : std::nullopt);
  }
  return lights;
}

}  // namespace ligne
