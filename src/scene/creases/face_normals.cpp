#include "scene/creases/face_normals.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "scene/model/face_shape.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Largest number of slivers passed on the way to a face that has a normal. Adjustable.
constexpr int kLongestChain = 8;

/// Least cosine of the angles in MeshAngles::flat: flat_joints() uses none below 0.999.
constexpr float kLeastFlatCosine = 0.998F;
/// A smaller cosine of float32 normals, computed in float32, surely means a bend. Below the second, its error and those of
/// the normals' lengths, 10 units of 2^-24, are less than a hundredth of its distance from 1.
constexpr float kSurelyBent = 1 - 12 * 0x1p-24F, kClearlyBent = 1 - 1000 * 0x1p-24F;
/// The squared distance of the normals' ends in distances of the cosine from 1, less that hundredth.
constexpr float kBendPart = 1.98F;
/// Factor on a squared tolerance that exceeds the relative error of the squared sine of such a bend.
constexpr double kBendMargin = 1.25;
/// Largest and least number that float32 can surely hold.
constexpr double kLargest = 1e30, kLeast = 1e-300;

/// The normal of a triangle, zero for slivers, and the square of its least height.
struct TriangleShape {
  Point3 normal{0, 0, 0};
  double squared_height = 0;
};

/// `sure`: a squared height above which a triangle of this object is surely no sliver.
TriangleShape shape_of(const Point3& a, const Point3& b, const Point3& c, double precision, double sure) {
  const Point3 ab = b - a, ac = c - a, bc = c - b;
  const Point3 area = glm::cross(ab, ac);
  const double longest2 = std::max(std::max(glm::dot(ab, ab), glm::dot(bc, bc)), glm::dot(ac, ac));
  const double area2 = glm::dot(area, area), length = std::sqrt(area2);
  const double height2 = longest2 > 0 ? area2 / longest2 : 0;
  if (!(height2 > sure)) {
    const double longest = std::sqrt(longest2);
    if (length <= straightness_tolerance(precision, longest) * longest) return {{0, 0, 0}, height2};
  }
  return {area / length, height2};
}

/// Gives a face without a normal the normal of its neighbour across its longest edge. If everything around is thinner than
/// the precision, as in terrain whose eastings were written with six digits, the faces keep their own normals, since
/// there are no better ones.
void take_from_neighbours(const Scene& scene, const Topology& topology, std::vector<glm::vec3>& normals) {
  std::vector<std::uint8_t> flat(normals.size());
  for (std::size_t f = 0; f < normals.size(); ++f) flat[f] = normals[f] == glm::vec3{0, 0, 0};
  const auto neighbours = longest_neighbours(scene, topology, flat, FlatNeighbours::taken);
  std::vector<std::pair<std::uint32_t, glm::vec3>> taken;
  for (const auto& [face, first] : neighbours) {
    bool turned = false, found = false;
    LongestNeighbour next = first;
    for (int k = 0; k < kLongestChain; ++k) {
      turned ^= next.turned;
      if (!flat[next.face]) {
        taken.emplace_back(face, turned ? -normals[next.face] : normals[next.face]);
        found = true;
        break;
      }
      const auto further = neighbours.find(next.face);
      if (further == neighbours.end()) break;
      next = further->second;
    }
    if (!found) taken.emplace_back(face, face_normal(scene, face));
  }
  for (const auto& [face, normal] : taken) normals[face] = normal;
}

/// TriangleShapes::height_units of an object of a given size.
double height_unit(const Object& object, double size) {
  const double tolerance = planarity_tolerance(object.precision, size);
  return std::max(kBendMargin * tolerance * tolerance, kLeast);
}

/// face_normals(). `heights` is empty, or takes TriangleShapes::heights in `units`, at most kLargest.
std::vector<glm::vec3> measure_faces(const Scene& scene, const Topology& topology, std::span<const double> units,
                                     std::span<float> heights) {
  std::vector<glm::vec3> normals = large_vector<glm::vec3>(scene.faces.size());
  std::atomic<bool> any_without{false};
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  const bool all_triangles = scene.faces.all_triangles();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const double scale = heights.empty() ? 0 : 1 / units[i];
    // The unit exceeds the squared tolerance for slivers.
    const double sure = heights.empty() ? std::numeric_limits<double>::infinity() : units[i];
    parallel_blocks(object.face_end - object.face_begin, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      bool without = false;
      for (std::size_t f = object.face_begin + begin; f < object.face_begin + end; ++f) {
        if (all_triangles) prefetch_corners(scene.vertices, corners, f);
        const std::span<const std::uint32_t> v = all_triangles ? corners.subspan(3 * f, 3) : scene.faces.contour(f, 0);
        if (v.size() == 3) {
          const TriangleShape shape =
              shape_of(scene.vertices[v[0]], scene.vertices[v[1]], scene.vertices[v[2]], object.precision, sure);
          normals[f] = shape.normal;
          if (!heights.empty()) heights[f] = static_cast<float>(std::min(shape.squared_height * scale, kLargest));
        } else {
          normals[f] = face_normal(scene, static_cast<std::uint32_t>(f));
        }
        without = without || normals[f] == glm::vec3{0, 0, 0};
      }
      if (without) any_without.store(true, std::memory_order_relaxed);
    });
  }
  if (any_without) take_from_neighbours(scene, topology, normals);
  return normals;
}

/// Whether two triangles surely do not lie in one plane. The third corner of either lies from the plane of the other by its
/// height over the edge times the sine of the bend, which little exceeds the distance of the normals' ends. `height`: that
/// of the lower one, as in TriangleShapes.
bool surely_bend(float height, float cosine, const glm::vec3& first, const glm::vec3& second) {
  // The distance follows from the cosine, unless that is near 1.
  if (cosine < kClearlyBent) return height * (kBendPart * (1 - cosine)) > 1;
  if (!(cosine < kSurelyBent)) return false;
  const glm::vec3 turn = first - second;
  return height * glm::dot(turn, turn) > 1;
}

/// Prefetches what the angle at an edge needs.
[[gnu::always_inline]] inline void prefetch_faces(const std::vector<glm::vec3>& normals, const std::vector<float>& heights,
                                                  const Edge& edge) {
  const std::uint32_t second = edge.face1 == kNone ? edge.face0 : edge.face1;
  prefetch(normals, std::array{edge.face0, second});
  if (!heights.empty()) prefetch(heights, std::array{edge.face0, second});
}

}  // namespace

std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology) {
  return measure_faces(scene, topology, {}, {});
}

MeshAngles mesh_angles(const Scene& scene, const Topology& topology, std::span<const double> sizes) {
  MeshAngles angles;
  std::vector<float>& heights = angles.heights;
  if (scene.faces.all_triangles()) {
    heights = large_vector<float>(scene.faces.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      angles.height_units.push_back(height_unit(scene.objects[i], sizes[i]));
  }
  angles.normals = measure_faces(scene, topology, angles.height_units, heights);
  const std::vector<glm::vec3>& normals = angles.normals;
  angles.cosines = large_vector<float>(topology.edges.size());
  const std::size_t count = topology.edges.size();
  const Edge* const edges = topology.edges.data();
  angles.flat = indices_of_blocks(count, [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& flat) {
    for (std::size_t e = begin; e < end; ++e) {
      const Edge& edge = edges[e];
      prefetch_faces(normals, heights, edges[std::min(e + kTurnsAhead, count - 1)]);
      if (edge.face1 == kNone) {
        angles.cosines[e] = kNoCosine;
        continue;
      }
      const glm::vec3 &first = normals[edge.face0], &second = normals[edge.face1];
      const float cosine = angles.cosines[e] = glm::dot(first, second);
      if (cosine < kLeastFlatCosine) continue;
      if (heights.empty() || !surely_bend(std::min(heights[edge.face0], heights[edge.face1]), cosine, first, second))
        flat.push_back(static_cast<std::uint32_t>(e));
    }
  });
  return angles;
}

std::vector<std::uint32_t> turn_plane_slivers(const Scene& scene, const Topology& topology,
                                              std::span<const std::uint32_t> plane_edges, std::vector<glm::vec3>& normals) {
  std::vector<std::uint32_t> turned;
  for (const std::uint32_t e : plane_edges) {
    const Edge& edge = topology.edges[e];
    const bool is_first = is_sliver_face(scene, edge.face0);
    if (is_first == is_sliver_face(scene, edge.face1)) continue;
    const auto [sliver, plane] = is_first ? std::pair(edge.face0, edge.face1) : std::pair(edge.face1, edge.face0);
    normals[sliver] = topology.edge_flags[e] & kEdgeUnlikeWound ? -normals[plane] : normals[plane];
    turned.push_back(sliver);
  }
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t sliver : turned) {
    const auto corners = scene.faces.contour(sliver, 0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t e = edge_between(topology, corners[k], corners[(k + 1) % corners.size()]);
      if (e == kNone || topology.edges[e].face1 == kNone) continue;
      if (!std::ranges::binary_search(plane_edges, e)) edges.push_back(e);
    }
  }
  return edges;
}

}  // namespace ligne
