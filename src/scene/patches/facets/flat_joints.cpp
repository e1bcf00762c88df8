#include "scene/patches/facets/flat_joints.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/face_area.hpp"
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
    if (all_triangles_ || (is_triangle(edge.face0) && is_triangle(edge.face1))) return are_flat_triangles(edge);
    const double span = std::max(span_of(edge.face0), span_of(edge.face1));
    const double tolerance = planarity_tolerance(object_.precision, span);
    const Point3& at = scene_.vertices[edge.v0];
    return lies_in_plane(edge.face1, edge.face0, at, tolerance) || lies_in_plane(edge.face0, edge.face1, at, tolerance);
  }

 private:
  bool is_triangle(std::uint32_t f) const {
    return scene_.faces.contour_count(f) == 1 && scene_.faces.contour(f, 0).size() == 3;
  }

  /// Largest distance of a corner from the first one.
  double span_of(std::uint32_t f) const {
    const auto contour = scene_.faces.contour(f, 0);
    double most = 0;
    for (const std::uint32_t v : contour)
      most = std::max(most, glm::distance(scene_.vertices[v], scene_.vertices[contour[0]]));
    return most;
  }

  /// Whether the corners of a face lie in the plane of another one through a common vertex.
  bool lies_in_plane(std::uint32_t f, std::uint32_t other, const Point3& at, double tolerance) const {
    const Point3 area = double_area(scene_, other);
    const double size = glm::length(area);
    if (!(size > 0)) return false;
    const auto is_in = [&](std::uint32_t v) {
      return std::abs(glm::dot(scene_.vertices[v] - at, area)) <= tolerance * size;
    };
    for (std::size_t c = 0; c < scene_.faces.contour_count(f); ++c) {
      if (!std::ranges::all_of(scene_.faces.contour(f, c), is_in)) return false;
    }
    return true;
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
  const bool all_triangles_ = scene_.faces.all_triangles();
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

}  // namespace ligne
