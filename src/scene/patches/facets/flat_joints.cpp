#include "scene/patches/facets/flat_joints.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "base/uninitialized_vector.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/face_area.hpp"
#include "scene/model/planarity.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {
namespace {

/// Factor that exceeds the rounding of a bound.
constexpr double kBoundFactor = 1 + 0x1p-40;
/// Cosine of float32 normals, computed in float32, that surely is below that of kFlatBend.
constexpr float kSurelyBent = 1 - 12 * 0x1p-24F;
/// Factor on a squared tolerance that exceeds the relative error of the squared sine of such a bend.
constexpr double kBendMargin = 1.25;

double square(const Point3& p) { return glm::dot(p, p); }

class JointFinder {
 public:
  JointFinder(const Scene& scene, const Object& object, std::span<const glm::vec3> normals)
      : scene_(scene), object_(object), normals_(normals) {
    if (all_triangles_) measure_heights();
  }

  /// Prefetches what is_flat() reads for edges of the object some turns ahead.
  void prefetch(const Edge& edge) const {
    for (const std::uint32_t f : {edge.face0, edge.face1}) {
      if (f == kNone) continue;
      __builtin_prefetch(&normals_[f]);
      if (all_triangles_) __builtin_prefetch(&heights_[f - object_.face_begin]);
    }
  }

  bool is_flat(const Edge& edge) const {
    if (all_triangles_ && surely_bends(edge)) return false;
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
  /// Measures the triangles of the object.
  void measure_heights() {
    heights_ = UninitializedVector<float>(object_.face_end - object_.face_begin);
    const auto measure = [&](std::size_t begin, std::size_t end) {
      double longest2 = 0;
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t f = object_.face_begin + k;
        prefetch_corners(scene_.vertices, scene_.faces.corners(), f);
        const auto corners = scene_.faces.contour(f, 0);
        const Point3 &a = scene_.vertices[corners[0]], &b = scene_.vertices[corners[1]], &c = scene_.vertices[corners[2]];
        const Point3 ab = b - a, ac = c - a, bc = c - b;
        const double own2 = std::max({square(ab), square(ac), square(bc)});
        heights_[k] = own2 > 0 ? clamped(square(glm::cross(ab, ac)) / own2) : 0.0F;
        longest2 = std::max(longest2, own2);
      }
      return longest2;
    };
    const double longest2 = parallel_reduce(object_.face_end - object_.face_begin, kShortWorkBlock, 0.0, measure,
                                            [](double l, double r) { return std::max(l, r); });
    const double most = planarity_tolerance(object_.precision, std::sqrt(longest2));
    least_bend_ = std::max(clamped(kBendMargin * most * most), std::numeric_limits<float>::min());
  }

  /// Whether two triangles are surely not flat. The third corner of either lies from the plane of the other by its height
  /// over the edge times the sine of the bend, which little exceeds the distance of the normals' ends.
  bool surely_bends(const Edge& edge) const {
    const glm::vec3 &first = normals_[edge.face0], &second = normals_[edge.face1];
    const float cosine = glm::dot(first, second);
    if (!(cosine < kSurelyBent)) return false;
    const float height = std::min(heights_[edge.face0 - object_.face_begin], heights_[edge.face1 - object_.face_begin]);
    const glm::vec3 turn = first - second;
    return height * glm::dot(turn, turn) > least_bend_;
  }

  static float clamped(double value) { return static_cast<float>(std::min(value, 1e30)); }

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
  UninitializedVector<float> heights_;  ///< per triangle of the object: the square of its least height
  float least_bend_ = 0;                ///< see surely_bends()
};

}  // namespace

std::vector<std::uint32_t> flat_joints(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                                       std::span<const glm::vec3> normals) {
  const JointFinder finder(scene, object, normals);
  return indices_where(edges.end - edges.begin, [&](std::size_t k) {
    const auto e = static_cast<std::uint32_t>(edges.begin + k);
    if (e + kTurnsAhead < edges.end) finder.prefetch(topology.edges[e + kTurnsAhead]);
    return may_be_smooth(topology, e) && finder.is_flat(topology.edges[e]);
  });
}

}  // namespace ligne
