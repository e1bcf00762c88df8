#include "scene/patches/facets/inflections.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/patches/facets/flat_joints.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest number of sides of a face of a strip.
constexpr std::size_t kMostSides = 4;
/// Least cosine of the angle between the ruling and the edges beyond its strips (18 degrees): those of a torus are chords of
/// circles.
constexpr double kParallelCosine = 0.95;
/// Range of the bends there, radians: one degree, and less than eight facets a turn.
constexpr double kLeastBend = std::numbers::pi / 180, kLargestBend = std::numbers::pi / 4;
/// Largest ratio between both bends.
constexpr double kLikeBends = 1.1;

class InflectionFinder {
 public:
  InflectionFinder(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals)
      : scene_(scene), topology_(topology), normals_(normals), rows_(scene, topology, normals) {}

  bool is_inflection(std::uint32_t e) const {
    if (is_diagonal(e, topology_.edges[e].face0) || is_diagonal(e, topology_.edges[e].face1)) return false;
    const double first = bend_beyond(e, topology_.edges[e].face0);
    if (first == 0) return false;
    const double second = bend_beyond(e, topology_.edges[e].face1);
    return first * second < 0 && std::abs(first) <= kLikeBends * std::abs(second) &&
           std::abs(second) <= kLikeBends * std::abs(first);
  }

 private:
  /// Whether an edge is longer than the other two of a triangle, as the rulings of strips are not.
  bool is_diagonal(std::uint32_t e, std::uint32_t face) const {
    const auto corners = scene_.faces.contour(face, 0);
    if (corners.size() != 3) return false;
    const Edge& edge = topology_.edges[e];
    const Point3 &a = scene_.vertices[edge.v0], &b = scene_.vertices[edge.v1];
    const Point3& c = scene_.vertices[corners[0] + corners[1] + corners[2] - edge.v0 - edge.v1];
    const double length = glm::dot(b - a, b - a);
    return length > glm::dot(c - a, c - a) && length > glm::dot(c - b, c - b);
  }

  /// The bend at the edge beyond the strip of a face, about parallel to an edge of the face; 0 if there is none in the
  /// range. The strip is the face, or two triangles.
  double bend_beyond(std::uint32_t e, std::uint32_t face) const {
    double bend = 0;
    for_sides(face, [&](std::uint32_t side, std::uint32_t other) {
      if (side == e || bend != 0) return;
      bend = bend_at(e, side, face);
      const bool is_flat = glm::dot(Point3(normals_[face]), Point3(normals_[other])) >= kFlatCosine;
      if (bend != 0 || !is_flat || scene_.faces.contour(face, 0).size() > 3) return;
      for_sides(other, [&](std::uint32_t far, std::uint32_t) {
        if (far != side && bend == 0) bend = bend_at(e, far, other);
      });
    });
    return bend;
  }

  double bend_at(std::uint32_t e, std::uint32_t side, std::uint32_t face) const {
    const Edge &a = topology_.edges[e], &b = topology_.edges[side];
    if (a.v0 == b.v0 || a.v0 == b.v1 || a.v1 == b.v0 || a.v1 == b.v1) return 0;
    const Point3 one = scene_.vertices[a.v1] - scene_.vertices[a.v0], two = scene_.vertices[b.v1] - scene_.vertices[b.v0];
    if (std::abs(glm::dot(one, two)) < kParallelCosine * glm::length(one) * glm::length(two)) return 0;
    const double bend = rows_.bend(side, face);
    return std::abs(bend) >= kLeastBend && std::abs(bend) <= kLargestBend ? bend : 0;
  }

  /// Visits the sides of a face of few of them at which there is one other face, with that.
  template <class Visit>
  void for_sides(std::uint32_t face, Visit&& visit) const {
    const auto contour = scene_.faces.contour(face, 0);
    if (contour.size() > kMostSides) return;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Edge* side = find_edge(topology_, {contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]});
      if (!side) continue;
      const auto number = static_cast<std::uint32_t>(side - topology_.edges.data());
      if (may_be_smooth(topology_, number)) visit(number, side->face0 == face ? side->face1 : side->face0);
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  std::span<const glm::vec3> normals_;
  EdgeRows rows_;
};

}  // namespace

std::vector<std::uint32_t> without_inflections(const Scene& scene, const Topology& topology, std::uint32_t first_edge,
                                               std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints) {
  const InflectionFinder finder(scene, topology, normals);
  std::vector<std::uint32_t> others =
      indices_where(joints.size(), [&](std::size_t i) { return !finder.is_inflection(first_edge + joints[i]); });
  for (std::uint32_t& i : others) i = joints[i];
  return others;
}

}  // namespace ligne
