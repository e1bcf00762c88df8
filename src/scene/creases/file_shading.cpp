#include "scene/creases/file_shading.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "geometry/parallel.hpp"
#include "scene/clean/weld.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Adjustable: normals as near to each other are one; and as near to that of the face are shading it flat.
constexpr double kSameDegrees = 5;
constexpr double kFlatShadingDegrees = 1;
/// Less than the 45 degrees of a chamfer: what averaged normals may make smooth.
constexpr double kAveragedDegrees = 40;

constexpr std::uint32_t kLevels = 1023;

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

bool within(std::uint32_t a, std::uint32_t b, double least_cosine) {
  return a == b || glm::dot(unpacked_direction(a), unpacked_direction(b)) >= least_cosine;
}

/// A side of a face, by the positions of its ends.
struct Side {
  std::uint32_t low, high;
  std::uint32_t corner, next;  ///< where it begins, and the corner at its end
  std::uint32_t face;
  friend bool operator<(const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, a.corner) < std::tuple(b.low, b.high, b.corner);
  }
};

std::vector<Side> sides_of(const Scene& scene) {
  const Weld weld = weld_vertices(scene);
  std::vector<Side> sides;
  sides.reserve(scene.faces.corners().size());
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      const auto first = static_cast<std::uint32_t>(scene.faces.corner_index(f, c));
      const auto n = static_cast<std::uint32_t>(contour.size());
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t next = k + 1 == n ? 0 : k + 1;
        const std::uint32_t a = weld.first[contour[k]], b = weld.first[contour[next]];
        if (a == kNone || b == kNone || a == b) continue;
        sides.push_back({std::min(a, b), std::max(a, b), first + k, first + next, f});
      }
    }
  }
  parallel_sort(sides.begin(), sides.end());
  return sides;
}

class Marker {
 public:
  Marker(Scene& scene, const FileShading& shading) : scene_(scene), shading_(shading) {}

  void run() {
    const std::vector<Side> sides = sides_of(scene_);
    normals_.resize(scene_.faces.size());
    parallel_blocks(normals_.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) normals_[f] = face_normal(scene_, static_cast<std::uint32_t>(f));
    });
    if (scene_.corner_flags.empty()) scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
    std::vector<std::pair<const Side*, const Side*>> smooth;
    std::vector<std::uint8_t> has_sharp(scene_.objects.size(), 0);
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
      if (end - i == 2 && sides[i].face != sides[i + 1].face) {
        const Side &a = sides[i], &b = sides[i + 1];
        const Said said = said_of(a, b);
        if (said == Said::sharp) {
          mark(a, b, kCornerSharp);
          has_sharp[object_of(a.face)] = 1;
        }
        if (said == Said::smooth) smooth.emplace_back(&a, &b);
      }
      i = end;
    }
    const double averaged = cosine(kAveragedDegrees);
    for (const auto& [a, b] : smooth) {
      if (has_sharp[object_of(a->face)] || bend(*a, *b) >= averaged) mark(*a, *b, kCornerSmooth);
    }
  }

 private:
  enum class Said { nothing, smooth, sharp };

  std::size_t object_of(std::uint32_t face) const {
    const auto after = std::upper_bound(scene_.objects.begin(), scene_.objects.end(), face,
                                        [](std::uint32_t f, const Object& object) { return f < object.face_end; });
    return static_cast<std::size_t>(after - scene_.objects.begin());
  }

  /// Whether both run from the same end of the edge to the other: then the faces are wound against each other.
  bool same_way(const Side& a, const Side& b) const {
    const auto corners = std::as_const(scene_.faces).corners();
    return scene_.vertices[corners[a.corner]] == scene_.vertices[corners[b.corner]];
  }

  /// Cosine of the angle between the faces' normals.
  double bend(const Side& a, const Side& b) const {
    return glm::dot(normals_[a.face], normals_[b.face]) * (same_way(a, b) ? -1 : 1);
  }

  Said said_of(const Side& a, const Side& b) const {
    if (!shading_.corner_normals.empty()) {
      const auto& n = shading_.corner_normals;
      if (n[a.corner] && n[a.next] && n[b.corner] && n[b.next]) return by_normals(a, b);
    }
    return shading_.face_groups.empty() ? Said::nothing : by_groups(a.face, b.face);
  }

  Said by_normals(const Side& a, const Side& b) const {
    const auto& n = shading_.corner_normals;
    if (is_flat(a) && is_flat(b)) return Said::nothing;
    const bool like = same_way(a, b);
    const std::uint32_t at_start = like ? b.corner : b.next, at_end = like ? b.next : b.corner;
    const double same = cosine(kSameDegrees);
    return within(n[a.corner], n[at_start], same) || within(n[a.next], n[at_end], same) ? Said::smooth : Said::sharp;
  }

  /// Files disagree on the side to which a face looks.
  bool is_flat(const Side& side) const {
    const double flat = cosine(kFlatShadingDegrees);
    for (const std::uint32_t corner : {side.corner, side.next}) {
      const Point3 normal = unpacked_direction(shading_.corner_normals[corner]);
      if (std::abs(glm::dot(normal, normals_[side.face])) < flat) return false;
    }
    return true;
  }

  Said by_groups(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t p = shading_.face_groups[a], q = shading_.face_groups[b];
    if (p == 0 && q == 0) return Said::nothing;
    return (shading_.groups_are_bits ? (p & q) != 0 : p == q) ? Said::smooth : Said::sharp;
  }

  void mark(const Side& a, const Side& b, std::uint8_t flag) {
    scene_.corner_flags[a.corner] |= flag;
    scene_.corner_flags[b.corner] |= flag;
  }

  Scene& scene_;
  const FileShading& shading_;
  std::vector<Point3> normals_;
};

}  // namespace

std::uint32_t packed_direction(const Point3& direction) {
  const double length = glm::length(direction);
  if (!(length > 0) || !std::isfinite(length)) return 0;
  std::uint32_t packed = 0;
  for (int k = 0; k < 3; ++k) {
    const double level = std::round((direction[k] / length + 1) / 2 * kLevels);
    packed = packed << 10 | static_cast<std::uint32_t>(std::clamp(level, 0.0, double{kLevels}));
  }
  return packed + 1;  // 0 is none
}

Point3 unpacked_direction(std::uint32_t packed) {
  --packed;
  Point3 direction;
  for (int k = 2; k >= 0; --k, packed >>= 10) direction[k] = static_cast<double>(packed & kLevels) / kLevels * 2 - 1;
  return glm::normalize(direction);
}

void mark_smooth_edges(Scene& scene, const FileShading& shading) {
  if (shading.corner_normals.empty() && shading.face_groups.empty()) return;
  Marker(scene, shading).run();
}

}  // namespace ligne
