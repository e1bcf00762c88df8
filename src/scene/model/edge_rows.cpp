#include "scene/model/edge_rows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/model/faces_and_edges.hpp"

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
  bool is_along = false;
  for_sides(scene.faces, face, [&](std::uint32_t v, std::uint32_t w) { is_along |= v == edge.v0 && w == edge.v1; });
  return is_along;
}

/// Whether an angle between faces is less than kOneFacet.
bool is_in_one_facet(double sine, double cosine) {
  // Angles that are not near the limit are compared with it by their tangents.
  constexpr double kNear = 1.001;
  if (cosine > 0 && sine > kNear * kOneFacet * cosine) return false;
  return sine < kOneFacet * cosine / kNear || std::atan2(sine, cosine) < kOneFacet;
}

}  // namespace

EdgeRows::Turn EdgeRows::turn_at(std::uint32_t edge, std::uint32_t face) const {
  const Edge& at = topology_.edges[edge];
  const Point3 here(normals_[face]), there(normals_[at.face0 == face ? at.face1 : at.face0]),
      across = glm::cross(here, there);
  return {across, glm::length(across), glm::dot(here, there)};
}

double EdgeRows::signed_angle(const Turn& turn, std::uint32_t edge, std::uint32_t face) const {
  const double angle = std::atan2(turn.sine, turn.cosine);
  return (glm::dot(turn.across, along(edge)) < 0) == goes_along(scene_, face, topology_.edges[edge]) ? -angle : angle;
}

double EdgeRows::bend(std::uint32_t edge, std::uint32_t face) const { return signed_angle(turn_at(edge, face), edge, face); }

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
      const std::uint32_t edge = edge_between(topology_, contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
      if (edge == kNone || edge == from.edge || topology_.edges[edge].face1 == kNone) continue;
      if (topology_.edge_flags[edge] & (kEdgeManyFaces | kEdgeUnlikeWound)) continue;
      const Edge& side = topology_.edges[edge];
      const std::uint32_t other = other_face(side, faces[i]);
      // The angle is computed where the cheaper conditions hold.
      const bool touches = share_vertex(side, first), is_beside = i == 0 && touches;
      const Turn turn = is_beside ? Turn{} : turn_at(edge, faces[i]);
      const bool is_inner = !is_beside && is_in_one_facet(turn.sine, turn.cosine);
      if (is_inner || is_beside) {
        const auto end = faces.begin() + count;
        if (count < kMostFaces && std::find(faces.begin(), end, other) == end) faces[count++] = other;
      }
      if (is_inner || touches || (topology_.edge_flags[edge] & kEdgeSharp)) continue;
      const double cosine = std::abs(glm::dot(along(edge), direction));
      if (!(cosine > best_cosine)) continue;
      const double other_angle = signed_angle(turn, edge, faces[i]), ratio = other_angle / angle;
      if (!(ratio >= bends.least && ratio <= bends.most)) continue;
      if (std::abs(other_angle) > kPolygonBend) continue;
      const Point3 way = (scene_.vertices[side.v0] + scene_.vertices[side.v1]) * 0.5 - scene_.vertices[first.v0];
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
