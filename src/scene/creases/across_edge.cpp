#include "scene/creases/across_edge.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Smallest ratio of the width of a side to that of a face of the fillet beside it. Adjustable.
constexpr double kWideTimes = 4;
/// Largest number of triangles searched for the side, two per face of the fillet.
constexpr int kMostFaces = 8;
/// Smallest distance of a middle edge from either end of the fillet, relative to the width. Adjustable.
constexpr double kMiddlePart = 1.0 / 3;
/// Cosine of 45 degrees: edges along a fillet, and the diagonals of its faces, deviate from it by less. Adjustable.
constexpr double kAlongCosine = 0.70710678;

/// The vector from a line to a point, perpendicular to the line.
Point3 across_line(const Point3& start, const Point3& along, const Point3& p) {
  return p - start - glm::dot(p - start, along) * along;
}

Point3 direction(const Scene& scene, const Edge& edge) {
  return glm::normalize(scene.vertices[edge.v1] - scene.vertices[edge.v0]);
}

/// The edge of a face, other than the given one, that is most parallel to a direction; null if all run across it.
const Edge* opposite_edge(const Scene& scene, const Topology& topology, const Edge& edge, std::uint32_t f,
                          const Point3& along) {
  const auto contour = scene.faces.contour(f, 0);
  std::pair<std::uint32_t, std::uint32_t> best{kNone, kNone};
  double most = kAlongCosine;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const std::uint32_t a = contour[k], b = contour[k + 1 == contour.size() ? 0 : k + 1];
    if (std::min(a, b) == edge.v0 && std::max(a, b) == edge.v1) continue;
    const Point3 d = scene.vertices[b] - scene.vertices[a];
    const double cosine = std::abs(glm::dot(d, along)) / glm::length(d);
    if (cosine <= most) continue;
    most = cosine;
    best = {a, b};
  }
  return best.first == kNone ? nullptr : find_edge(topology, best);
}

/// Walks from the edge across one of its faces and further ones to a face that is much wider than `narrow`.
bool find_wide_side(const Scene& scene, const Topology& topology, const Edge& start, double narrow, double& way,
                    std::uint32_t& f) {
  const Point3 along = direction(scene, start);
  const Edge* edge = &start;
  for (int faces = 0; faces < kMostFaces; ++faces) {
    if (glm::length(across_face(scene, *edge, f)) >= kWideTimes * narrow) {
      const Point3 middle = (scene.vertices[edge->v0] + scene.vertices[edge->v1]) * 0.5;
      way = glm::length(across_line(scene.vertices[start.v0], along, middle));
      return true;
    }
    edge = opposite_edge(scene, topology, *edge, f, along);
    if (!edge || edge->face1 == kNone) return false;
    f = edge->face0 == f ? edge->face1 : edge->face0;
  }
  return false;
}

}  // namespace

Point3 across_face(const Scene& scene, const Edge& edge, std::uint32_t f) {
  const Point3 along = direction(scene, edge);
  Point3 farthest{0, 0, 0};
  for (const std::uint32_t v : scene.faces.contour(f, 0)) {
    const Point3 across = across_line(scene.vertices[edge.v0], along, scene.vertices[v]);
    if (glm::dot(across, across) > glm::dot(farthest, farthest)) farthest = across;
  }
  return farthest;
}

std::array<double, 2> widths_across(const Scene& scene, const Edge& edge) {
  return {glm::length(across_face(scene, edge, edge.face0)), glm::length(across_face(scene, edge, edge.face1))};
}

bool Fillet::in_middle() const { return std::ranges::min(ways) > kMiddlePart * width(); }

std::optional<Fillet> fillet_at(const Scene& scene, const Topology& topology, const Edge& edge, double narrow) {
  Fillet found{{}, {edge.face0, edge.face1}};
  for (const int k : {0, 1}) {
    if (!find_wide_side(scene, topology, edge, narrow, found.ways[k], found.sides[k])) return std::nullopt;
  }
  return found;
}

}  // namespace ligne
