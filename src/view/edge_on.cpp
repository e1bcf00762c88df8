#include "view/edge_on.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "scene/model/planarity.hpp"
#include "view/edge_classes.hpp"

namespace ligne {
namespace {

/// Relative rounding of the eye and the line of sight: they result from a few double operations on coordinates as large
/// as the largest one.
constexpr double kViewRounding = 0x1p-50;
/// Relative rounding of the mixed product: three differences, two products and a difference, and a sum of three
/// products.
constexpr double kMixedProductRounding = 0x1p-50;

/// Cosine of the angle between the normal of a triangle and a line of sight, in float32, from which on it tells where the
/// triangle faces. It exceeds kNearlyEdgeOnSine and the rounding of the cosine.
constexpr float kSurelyFacing = 0x1p-9F;
static_assert(kSurelyFacing > kNearlyEdgeOnSine);

/// Larger than all TriangleShapes::heights, which stay a factor of 10^8 below it, and still a float32. A bound that
/// underflows instead needs no limit: heights above kOwnNormalHeight at cosines above kSurelyFacing exceed it anyway.
constexpr double kBeyondHeights = std::numeric_limits<float>::max();

/// Factor that exceeds the rounding of the bound below.
constexpr double kBoundRounding = 1 + 0x1p-40;

double sum_of_sizes(const Point3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Sum of the sizes of the products in (a x b) . c.
double product_sizes(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 p = glm::abs(a), q = glm::abs(b), s = glm::abs(c);
  return (p.y * q.z + p.z * q.y) * s.x + (p.z * q.x + p.x * q.z) * s.y + (p.x * q.y + p.y * q.x) * s.z;
}

/// Whether a triangle with the sides pq and pr is certainly not seen edge on along the given sight, which holds for
/// nearly all. Sums of sizes bound every term of the test: a product's terms are bounded by the product of the sums,
/// and the third side by the two others. `mixed`: size of the mixed product.
bool is_surely_broad(const Point3& pq, const Point3& pr, double mixed, double sight_sizes, double rounding) {
  const double a = sum_of_sizes(pq), b = sum_of_sizes(pr);
  return mixed > kBoundRounding * sight_sizes * (kMixedProductRounding * a * b + 2 * rounding * (a + b));
}

}  // namespace

double view_rounding(const Camera& camera, double largest) {
  return kViewRounding * std::max(sum_of_sizes(camera.eye), largest);
}

bool is_seen_edge_on(const Point3& p, const Point3& q, const Point3& r, const Camera& camera, double precision,
                     double rounding) {
  const Point3 pq = q - p, pr = r - p, normal = glm::cross(pq, pr);
  const Point3 sight = camera.perspective ? p - camera.eye : camera.forward;
  const double mixed = std::abs(glm::dot(normal, sight));
  const double product = mixed - kMixedProductRounding * product_sizes(pq, pr, sight);
  if (!camera.perspective) {
    const auto moved = [&](const Point3& side) { return sum_of_sizes(glm::cross(sight, side)); };
    return product <= rounding * (moved(pq) + moved(pr) + moved(r - q));
  }
  const Point3 to_q = q - camera.eye, to_r = r - camera.eye;
  const auto moved = [&](const Point3& v, const Point3& w) { return sum_of_sizes(glm::cross(v, w)); };
  return product <=
         precision * sum_of_sizes(normal) + rounding * (moved(to_q, to_r) + moved(to_r, sight) + moved(sight, to_q));
}

std::vector<std::int8_t> sure_facings(const Scene& scene, const Camera& camera, const TriangleShapes& shapes,
                                      double largest) {
  if (camera.perspective || shapes.heights.empty()) return {};
  // By the bounds of is_surely_broad(), a triangle of longest side L and least height h, which spans an area h L, is broad
  // if the cosine c of its normal with the sight fulfils h c > S (3 m L + 4 sqrt(3) r), with the sizes S of the sight, the
  // rounding m of the mixed product, and the rounding r of the view. The margin exceeds the rounding of c.
  constexpr double kMargin = 2;
  const double longest = 2 * kSqrt3 * largest;
  const double least = kMargin * sum_of_sizes(camera.forward) *
                       (3 * kMixedProductRounding * longest + 4 * kSqrt3 * view_rounding(camera, largest));
  const glm::vec3 sight(glm::normalize(camera.forward));
  std::vector<std::int8_t> facings = large_vector<std::int8_t>(scene.faces.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const auto least_square = static_cast<float>(std::min(least * least / shapes.height_units[i], kBeyondHeights));
    parallel_blocks(object.face_end - object.face_begin, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = object.face_begin + begin; f < object.face_begin + end; ++f) {
        const float cosine = glm::dot(shapes.normals[f], sight), height = shapes.heights[f];
        const bool is_sure =
            (std::abs(cosine) > kSurelyFacing) & (height > kOwnNormalHeight) & (height * cosine * cosine > least_square);
        facings[f] = is_sure ? (cosine < 0 ? 1 : -1) : 0;
      }
    });
  }
  return facings;
}

std::vector<std::uint8_t> faces_seen_edge_on(const Scene& scene, const Topology& topology, const Camera& camera,
                                             double largest, std::span<const std::int8_t> sure) {
  const double rounding = view_rounding(camera, largest);
  const double forward_sizes = sum_of_sizes(camera.forward);
  // A face is seen edge on when all its triangles are.
  const std::vector<Triangle>& triangles = topology.triangles;
  std::vector<std::uint8_t> edge_on(triangles.size());
  std::atomic<bool> any{false};
  parallel_blocks(triangles.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    std::size_t object =
        static_cast<std::size_t>(std::partition_point(scene.objects.begin(), scene.objects.end(),
                                                      [&](const Object& o) { return o.face_end <= triangles[begin].face; }) -
                                 scene.objects.begin());
    bool found = false;
    for (std::size_t i = begin; i < end; ++i) {
      if (!sure.empty() && sure[i] != 0) continue;
      if (sure.empty() && i + kTurnsAhead < end) prefetch(scene.vertices, triangles[i + kTurnsAhead].v);
      const Triangle& t = triangles[i];
      while (t.face >= scene.objects[object].face_end) ++object;
      const Point3 &p = scene.vertices[t.v[0]], &q = scene.vertices[t.v[1]], &r = scene.vertices[t.v[2]];
      if (!camera.perspective) {
        const Point3 pq = q - p, pr = r - p;
        const double mixed = std::abs(glm::dot(glm::cross(pq, pr), camera.forward));
        if (is_surely_broad(pq, pr, mixed, forward_sizes, rounding)) continue;
      }
      edge_on[i] = is_seen_edge_on(p, q, r, camera, scene.objects[object].precision, rounding);
      found = found || edge_on[i];
    }
    if (found) any = true;
  });
  if (!any) return {};
  std::vector<std::uint8_t> result(scene.faces.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const bool first_of_face = i == 0 || triangles[i - 1].face != triangles[i].face;
    std::uint8_t& of_face = result[triangles[i].face];
    of_face = edge_on[i] && (first_of_face || of_face);
  }
  return std::find(result.begin(), result.end(), 1) == result.end() ? std::vector<std::uint8_t>{} : result;
}

}  // namespace ligne
