#include "scene/patches/facets/flat_joints.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/indices_where.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {
namespace {

/// Factor that exceeds the rounding of a bound.
constexpr double kBoundFactor = 1 + 0x1p-40;

double square(const Point3& p) { return glm::dot(p, p); }

class JointFinder {
 public:
  JointFinder(const Scene& scene, const Object& object, std::span<const glm::vec3> normals)
      : scene_(scene), object_(object), normals_(normals) {}

  bool is_flat(const Edge& edge) const {
    const double cosine = glm::dot(Point3(normals_[edge.face0]), Point3(normals_[edge.face1]));
    if (cosine < kFlatCosine) return false;
    if (cosine > flat_) return true;
    if (is_triangle(scene_.faces, edge.face0) && is_triangle(scene_.faces, edge.face1)) return are_flat_triangles(edge);
    const double span = std::max(face_span(scene_, edge.face0), face_span(scene_, edge.face1));
    const double tolerance = planarity_tolerance(object_.precision, span);
    const Point3& at = scene_.vertices[edge.v0];
    return lies_in_plane(edge.face1, edge.face0, at, tolerance) || lies_in_plane(edge.face0, edge.face1, at, tolerance);
  }

 private:
  /// Whether the corners of a face lie in the plane of another one through a common vertex.
  bool lies_in_plane(std::uint32_t f, std::uint32_t other, const Point3& at, double tolerance) const {
    const Point3 area = double_area(scene_, other);
    const double size = glm::length(area);
    if (!(size > 0)) return false;
    const auto is_in = [&](std::uint32_t v) {
      return std::abs(glm::dot(scene_.vertices[v] - at, area)) <= tolerance * size;
    };
    return std::ranges::all_of(corners_of(scene_.faces, f), is_in);
  }

  /// The corner of a triangle that is no end of an edge of it.
  const Point3& corner_beside(std::uint32_t triangle, const Edge& edge) const {
    const auto corners = scene_.faces.contour(triangle, 0);
    return scene_.vertices[corners[0] + corners[1] + corners[2] - edge.v0 - edge.v1];
  }

  /// is_flat() for two triangles: the third corner of one of them lies in the plane of the other.
  bool are_flat_triangles(const Edge& edge) const {
    const Point3& at = scene_.vertices[edge.v0];
    const Point3 along = scene_.vertices[edge.v1] - at;
    const Point3 first = corner_beside(edge.face0, edge) - at, second = corner_beside(edge.face1, edge) - at;
    const Point3 first_area = glm::cross(along, first);
    const double along2 = square(along), first2 = square(first), second2 = square(second);
    const double volume = std::abs(glm::dot(first_area, second));
    // Upper bounds of the tolerance and of the areas decide for nearly all edges of curved surfaces.
    const double most = kBoundFactor * planarity_tolerance(object_.precision, std::sqrt(2 * (along2 + first2 + second2)));
    if (volume * volume > most * most * std::max(square(first_area), along2 * second2)) return false;
    const Point3 second_area = glm::cross(along, second);
    const double size = std::max(square(first_area), square(second_area));
    const double span = std::max({along2, first2, second2, square(first - along), square(second - along)});
    return size > 0 && volume <= planarity_tolerance(object_.precision, std::sqrt(span)) * std::sqrt(size);
  }

  const double flat_ = sine_cosine_degrees(kFlatBend).cosine;
  const Scene& scene_;
  const Object& object_;
  const std::span<const glm::vec3> normals_;
};

// Adjustable.
/// Largest number of sides of a face of a strip.
constexpr std::size_t kMostSides = 4;
/// Least cosine of the angle between the ruling and the edges beyond its strips (18 degrees): those of a torus are chords of
/// circles.
constexpr double kParallelCosine = 0.95;
/// Range of the bends there, radians: one degree, and less than eight facets a turn.
constexpr double kLeastJointBend = std::numbers::pi / 180, kLargestJointBend = std::numbers::pi / 4;
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
    if (share_vertex(a, b)) return 0;
    const Point3 one = scene_.vertices[a.v1] - scene_.vertices[a.v0], two = scene_.vertices[b.v1] - scene_.vertices[b.v0];
    if (std::abs(glm::dot(one, two)) < kParallelCosine * glm::length(one) * glm::length(two)) return 0;
    const double bend = rows_.bend(side, face);
    return std::abs(bend) >= kLeastJointBend && std::abs(bend) <= kLargestJointBend ? bend : 0;
  }

  /// Visits the sides of a face of few of them at which there is one other face, with that.
  template <class Visit>
  void for_sides(std::uint32_t face, Visit&& visit) const {
    const auto contour = scene_.faces.contour(face, 0);
    if (contour.size() > kMostSides) return;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t side = edge_between(topology_, contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
      if (side != kNone && may_be_smooth(topology_, side)) visit(side, other_face(topology_.edges[side], face));
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  std::span<const glm::vec3> normals_;
  EdgeRows rows_;
};

}  // namespace

std::vector<std::uint32_t> flat_joints(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                                       std::span<const glm::vec3> normals, std::span<const std::uint32_t> candidates) {
  const JointFinder finder(scene, object, normals);
  const auto first = std::ranges::lower_bound(candidates, edges.begin),
             last = std::ranges::lower_bound(candidates, edges.end);
  const std::span<const std::uint32_t> own(first, last);
  std::vector<std::uint32_t> joints = indices_where(own.size(), [&](std::size_t i) {
    prefetch_faces_of(scene, topology, own, 0, i);
    return may_be_smooth(topology, own[i]) && finder.is_flat(topology.edges[own[i]]);
  });
  for (std::uint32_t& joint : joints) joint = own[joint] - edges.begin;
  return joints;
}

std::vector<std::uint32_t> without_inflections(const Scene& scene, const Topology& topology, std::uint32_t first_edge,
                                               std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints) {
  const InflectionFinder finder(scene, topology, normals);
  std::vector<std::uint32_t> others =
      indices_where(joints.size(), [&](std::size_t i) { return !finder.is_inflection(first_edge + joints[i]); });
  for (std::uint32_t& i : others) i = joints[i];
  return others;
}

}  // namespace ligne
