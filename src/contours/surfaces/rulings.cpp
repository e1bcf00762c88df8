#include "contours/surfaces/rulings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "view/edge_classes.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Least ratio of the length of a ruling to the extent of the faces beyond its end, and of the width of a flat side to
/// the width of a fillet beside it. Chord errors use the same value (scene/contacts).
constexpr double kRulingRatio = 4;
/// Least sine of the angle between two rulings that span a flat side: 10 degrees.
constexpr double kLeastSpanSine = 0.17;
/// Largest sine of half the angle between two triangles of one rectangle or flat side: float32 coordinates turn small
/// triangles by about this much. Also the largest sine between an edge and the plane of a face that contains it.
constexpr double kInPlaneSine = 2e-4;
/// Largest number of pairs of edges that are compared at one vertex, the longest edges first. So the cost of a fan is
/// linear in the number of its triangles. Sectors of up to 50 triangles are compared completely.
constexpr std::size_t kMostPairs = 10'000;
/// Least cosine of the angle by which rulings may turn a mean normal: 45 degrees.
constexpr double kLeastKeptCosine = 0.707;

/// Half of the chord between unit normals, which is the sine of half of their angle; 1 where one of them is zero.
double half_chord(const Point3& n, const Point3& m) {
  if (n == Point3(0.0) || m == Point3(0.0)) return 1;
  return std::min(1.0, glm::length(n - m) / 2);
}

/// Finds the rulings that end at the vertex of a sector.
class RulingFinder {
 public:
  RulingFinder(const Scene& scene, std::span<const Point3> face_normals, const SmoothPatch& patch)
      : scene_(scene), face_normals_(face_normals), patch_(patch) {}

  const Point3& point(std::uint32_t corner) const { return scene_.vertices[patch_.triangles[corner / 3].v[corner % 3]]; }

  /// The normal nearest to `mean` that is perpendicular to the rulings of the sector with these corners. Returns
  /// nothing if there are no rulings, or if it differs too much from `mean`.
  std::optional<Point3> normal(std::span<const std::uint32_t> corners, const Point3& mean) const {
    const std::vector<Ruling> rulings = find(corners);
    if (rulings.empty()) return std::nullopt;
    const Point3& first = rulings[0].direction;
    for (const Ruling& other : rulings) {
      const Point3 across = glm::cross(first, other.direction);
      if (glm::length(across) >= kLeastSpanSine) return turned(glm::dot(across, mean) < 0 ? -across : across, mean);
    }
    return turned(mean - glm::dot(mean, first) * first, mean);
  }

 private:
  struct Ruling {
    double ratio;  ///< its length divided by the extent of the faces beyond its end
    Point3 direction;

    bool operator<(const Ruling& o) const {
      const auto key = [](const Ruling& r) { return std::tuple(-r.ratio, r.direction.x, r.direction.y, r.direction.z); };
      return key(*this) < key(o);
    }
  };

  /// An edge that leaves the vertex.
  struct Candidate {
    double length;
    Point3 direction;
    std::uint32_t corner;  ///< at the vertex, in a triangle at the edge
  };

  /// Whether the triangle is half of a rectangle, or part of a flat side.
  bool has_coplanar_neighbour(std::uint32_t t) const {
    for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
      const std::uint32_t r = patch_.across[side];
      if (r != kNone && half_chord(face_normals_[t], face_normals_[r / 3]) <= kInPlaneSine) return true;
    }
    return false;
  }

  /// Whether the longest edge is long enough to be a ruling. A quick test: few sectors have such an edge.
  bool has_long_edge(std::span<const std::uint32_t> corners) const {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const std::uint32_t c : corners) {
      for (const std::uint32_t end : {next_corner(c), previous_corner(c)}) {
        const Point3 edge = point(end) - point(c);
        const double square = glm::dot(edge, edge);
        shortest = std::min(shortest, square);
        longest = std::max(longest, square);
      }
    }
    return longest > kRulingRatio * kRulingRatio * shortest;
  }

  /// Finds the rulings of the sector, the largest ratio first. Their order does not depend on the order of the corners.
  std::vector<Ruling> find(std::span<const std::uint32_t> corners) const {
    if (!has_long_edge(corners)) return {};
    std::vector<Candidate> candidates;
    for (const std::uint32_t c : corners) {
      if (face_normals_[c / 3] == Point3(0.0) || !has_coplanar_neighbour(c / 3)) continue;
      for (const std::uint32_t end : {next_corner(c), previous_corner(c)}) {
        const Point3 edge = point(end) - point(c);
        if (const double length = glm::length(edge); length > 0) candidates.push_back({length, edge / length, c});
      }
    }
    const std::size_t most = kMostPairs / (2 * corners.size()) + 1;
    if (candidates.size() > most) {
      const auto last = candidates.begin() + static_cast<std::ptrdiff_t>(most);
      std::nth_element(candidates.begin(), last, candidates.end(), [](const Candidate& l, const Candidate& r) {
        const auto key = [](const Candidate& e) {
          return std::tuple(-e.length, e.direction.x, e.direction.y, e.direction.z);
        };
        return key(l) < key(r);
      });
      candidates.erase(last, candidates.end());
    }
    std::vector<Ruling> rulings;
    for (const Candidate& edge : candidates) {
      const double beyond = reach_beyond(corners, edge.corner, edge.direction);
      if (beyond > 0 && edge.length > kRulingRatio * beyond) rulings.push_back({edge.length / beyond, edge.direction});
    }
    std::sort(rulings.begin(), rulings.end());
    return rulings;
  }

  /// Scales `to` to unit length. Returns nothing if it differs too much from the mean normal: then the edges are no
  /// rulings of one surface.
  static std::optional<Point3> turned(const Point3& to, const Point3& mean) {
    const double size = glm::length(to);
    if (!(size > 0) || glm::dot(to, mean) < kLeastKeptCosine * size) return std::nullopt;
    return to / size;
  }

  /// Extent, against the direction of an edge, of the faces of the sector that bend away from the triangle of corner c.
  double reach_beyond(std::span<const std::uint32_t> corners, std::uint32_t c, const Point3& direction) const {
    double reach = 0;
    for (const std::uint32_t other : corners) {
      for (const std::uint32_t end : {next_corner(other), previous_corner(other)}) {
        const Point3 edge = point(end) - point(other);
        const double against = -glm::dot(edge, direction);
        if (against > reach && std::abs(glm::dot(edge, face_normals_[c / 3])) > kInPlaneSine * glm::length(edge)) {
          reach = against;
        }
      }
    }
    return reach;
  }

  const Scene& scene_;
  std::span<const Point3> face_normals_;
  const SmoothPatch& patch_;
};

}  // namespace

void square_to_rulings(const Scene& scene, const Camera& camera, std::span<const Point3> face_normals, SmoothPatch& patch) {
  const std::size_t sectors = patch.normals.size();
  patch.ruled.assign(sectors, 0);
  const auto corners_of_sectors =
      numbers_by_key(patch.normals.size(), patch.sector.size(), [&](std::uint32_t corner) { return patch.sector[corner]; });
  const RulingFinder finder(scene, face_normals, patch);
  parallel_blocks(sectors, kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s) {
      const auto around = corners_of_sectors[s];
      if (!patch.complete[around[0]] || patch.normals[s] == Point3(0.0)) continue;
      const std::optional<Point3> normal = finder.normal(around, patch.normals[s]);
      if (!normal) continue;
      patch.ruled[s] = 1;
      patch.normals[s] = *normal;
      const Point3 eye = to_eye(camera, finder.point(around[0]));
      const double g = glm::dot(*normal, eye);
      // A side that is seen edge on has one sign: rounding must not change it from vertex to vertex.
      patch.g[s] = std::abs(g) <= kEdgeOnSine * glm::length(eye) ? 0 : g;
    }
  });
}

double sag_of(const Scene& scene, const SmoothPatch& patch, std::uint32_t t) {
  const auto point = [&](std::uint32_t corner) { return scene.vertices[patch.triangles[corner / 3].v[corner % 3]]; };
  const auto normal = [&](std::uint32_t triangle) {
    const Point3 a = point(3 * triangle);
    const Point3 area = glm::cross(point(3 * triangle + 1) - a, point(3 * triangle + 2) - a);
    const double size = glm::length(area);
    return size > 0 ? area / size : Point3(0.0);
  };
  const auto width_from = [&](std::uint32_t side) {
    const Point3 along = point(next_corner(side)) - point(side);
    const double length = glm::length(along);
    return length > 0 ? glm::length(glm::cross(along, point(previous_corner(side)) - point(side))) / length : 0;
  };
  const Point3 n = normal(t);
  double sum = 0;
  for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
    const std::uint32_t r = patch.across[side];
    const double sine = r == kNone ? 1 : half_chord(n, normal(r / 3));
    if (sine == 1) continue;
    double width = width_from(side);
    const double beside = width_from(r);
    if (width > kRulingRatio * beside) width = beside;
    sum += width / 2 * sine / (1 + std::sqrt(1 - sine * sine));  // tan(t/4) = sin(t/2) / (1 + cos(t/2))
  }
  return sum;
}

}  // namespace ligne
