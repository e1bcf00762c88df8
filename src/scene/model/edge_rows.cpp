#include "scene/model/edge_rows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ligne {
namespace {

// Adjustable.
/// Largest number of sides of a face in a row: planes have more.
constexpr std::size_t kMostSides = 16;
/// Largest number of faces that are searched for the next edge of a row. A quadrilateral facet may be two triangles, and CSG
/// cuts facets into more.
constexpr std::size_t kMostFaces = 8;
/// Radians: bends of less than eight facets a turn are those of polygons (docs/patches.md).
constexpr double kPolygonBend = std::numbers::pi / 4 + 0.001;
/// Radians: faces that bend by less are parts of one facet (0.05 degrees).
constexpr double kOneFacet = 0.00087;

/// Whether a face passes an edge from its first vertex to its second one.
bool goes_along(const Scene& scene, std::uint32_t face, const Edge& edge) {
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto contour = scene.faces.contour(face, c);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      if (contour[k] == edge.v0 && contour[k + 1 == contour.size() ? 0 : k + 1] == edge.v1) return true;
    }
  }
  return false;
}

}  // namespace

double EdgeRows::bend(std::uint32_t edge, std::uint32_t face) const {
  const Edge& at = topology_.edges[edge];
  const Point3 here(normals_[face]), there(normals_[at.face0 == face ? at.face1 : at.face0]), turn = glm::cross(here, there);
  const double angle = std::atan2(glm::length(turn), glm::dot(here, there));
  return (glm::dot(turn, along(edge)) < 0) == goes_along(scene_, face, at) ? -angle : angle;
}

Point3 EdgeRows::along(std::uint32_t edge) const {
  return glm::normalize(scene_.vertices[topology_.edges[edge].v1] - scene_.vertices[topology_.edges[edge].v0]);
}

EdgeRows::Step EdgeRows::next(const Step& from, const RowBends& bends) const {
  if (scene_.faces.contour(from.face, 0).size() > kMostSides) return {};
  const Edge& first = topology_.edges[from.edge];
  const double angle = from.angle != 0 ? from.angle : bend(from.edge, from.face);
  if (std::abs(angle) > kPolygonBend) return {};
  const Point3 direction = along(from.edge);
  std::array<std::uint32_t, kMostFaces> faces{from.face};
  Step best;
  double best_cosine = bends.cosine;
  for (std::size_t i = 0, count = 1; i < count; ++i) {
    const auto contour = scene_.faces.contour(faces[i], 0);
    if (contour.size() > kMostSides) continue;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Edge* side = find_edge(topology_, {contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]});
      if (!side || side == &first || side->face1 == kNone) continue;
      const auto edge = static_cast<std::uint32_t>(side - topology_.edges.data());
      if (topology_.edge_flags[edge] & (kEdgeManyFaces | kEdgeUnlikeWound)) continue;
      const std::uint32_t other = side->face0 == faces[i] ? side->face1 : side->face0;
      const double other_angle = bend(edge, faces[i]);
      const bool is_inner = std::abs(other_angle) < kOneFacet, touches = share_vertex(*side, first);
      if (is_inner || (i == 0 && touches)) {
        const auto end = faces.begin() + count;
        if (count < kMostFaces && std::find(faces.begin(), end, other) == end) faces[count++] = other;
      }
      if (is_inner || touches || (topology_.edge_flags[edge] & kEdgeSharp)) continue;
      const double ratio = other_angle / angle, cosine = std::abs(glm::dot(along(edge), direction));
      if (!(ratio >= bends.least && ratio <= bends.most && cosine > best_cosine)) continue;
      if (std::abs(other_angle) > kPolygonBend) continue;
      const Point3 way = (scene_.vertices[side->v0] + scene_.vertices[side->v1]) * 0.5 - scene_.vertices[first.v0];
      best = {edge, other, glm::length(glm::cross(way, direction)), angle};
      best_cosine = cosine;
    }
  }
  return best;
}

std::optional<std::array<EdgeRows::Step, 2>> EdgeRows::beside(std::uint32_t edge, const RowBends& bends) const {
  const Edge& at = topology_.edges[edge];
  if (at.face1 == kNone || (topology_.edge_flags[edge] & (kEdgeManyFaces | kEdgeUnlikeWound))) return std::nullopt;
  const Step one = next({edge, at.face0}, bends);
  if (!one) return std::nullopt;
  const Step two = next({edge, at.face1}, bends);
  if (!two) return std::nullopt;
  return std::array{one, two};
}

}  // namespace ligne
