#include "scene/creases/file_shading.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/vertex_pair_index.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Largest angle between equal normals, and between a file's normal and that of its face where the face is shaded flat.
/// Adjustable.
constexpr double kSameDegrees = 5;
constexpr double kFlatShadingDegrees = 1;
/// Largest angle that averaged normals may make smooth: less than the 45 degrees of a chamfer.
constexpr double kAveragedDegrees = 40;

constexpr std::uint32_t kLevels = 1023;

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

/// Whether the cosine of the angle between two packed directions is at least `least_cosine`, which is not negative.
bool within(std::uint32_t a, std::uint32_t b, double least_cosine) {
  if (a == b) return true;
  const Point3 p = unpacked_direction(a), q = unpacked_direction(b);
  const double d = glm::dot(p, q);
  return d >= 0 && d * d >= least_cosine * least_cosine * glm::dot(p, p) * glm::dot(q, q);
}

/// A side of a face, by its first and its second corner.
struct Side {
  std::uint32_t corner, next;
  std::uint32_t face;
};

/// The sides of faces, indexed by their first corners.
class Sides {
 public:
  explicit Sides(const PolygonFaces& faces) {
    if (faces.all_triangles()) return;
    next_.resize(faces.corners().size());
    face_.resize(faces.corners().size());
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
        const std::size_t first = faces.corner_index(f, c), end = first + faces.contour(f, c).size();
        for (std::size_t k = first; k < end; ++k) {
          next_[k] = static_cast<std::uint32_t>(k + 1 == end ? first : k + 1);
          face_[k] = f;
        }
      }
    }
  }

  std::uint32_t next(std::uint32_t corner) const {
    if (!next_.empty()) return next_[corner];
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  Side operator[](std::uint32_t corner) const { return {corner, next(corner), face_.empty() ? corner / 3 : face_[corner]}; }

 private:
  std::vector<std::uint32_t> next_, face_;  ///< empty if all faces are triangles
};

/// The sides of all faces, filed by the positions of their ends. Sides with equal ends are left out.
VertexPairIndex file_sides(const Scene& scene, const Sides& sides, const Weld& weld) {
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  return VertexPairIndex(scene.vertices.size(), corners.size(), [&](const auto& add) {
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t a = weld.first[corners[k]], b = weld.first[corners[sides.next(k)]];
      if (a != kNone && b != kNone && a != b) add(a, b, k);
    }
  });
}

class Marker {
 public:
  Marker(Scene& scene, const FileShading& shading) : scene_(scene), shading_(shading), sides_(scene.faces) {}

  void run(const Weld& weld) {
    const VertexPairIndex filed = file_sides(scene_, sides_, weld);
    measure_faces();
    if (scene_.corner_flags.empty()) scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
    // Each side belongs to one pair, so no two tasks mark one corner.
    const std::size_t nodes = scene_.vertices.size(), blocks = block_count(nodes, kShortWorkBlock);
    std::vector<std::vector<std::pair<Side, Side>>> smooth(blocks);
    std::vector<std::vector<std::size_t>> sharp_objects(blocks);
    parallel_blocks(nodes, kShortWorkBlock, [&](std::size_t first, std::size_t last) {
      const std::size_t block = first / kShortWorkBlock;
      filed.for_each_pair(first, last, [&](std::uint32_t, std::span<const VertexPairIndex::Entry> pair) {
        if (pair.size() != 2) return;
        const Side a = sides_[pair[0].item], b = sides_[pair[1].item];
        if (a.face == b.face) return;
        const FileVerdict verdict = verdict_at(a, b);
        if (verdict == FileVerdict::smooth) smooth[block].emplace_back(a, b);
        if (verdict != FileVerdict::sharp) return;
        mark(a, b, kCornerSharp);
        const std::size_t object = object_of(a.face);
        if (sharp_objects[block].empty() || sharp_objects[block].back() != object) sharp_objects[block].push_back(object);
      });
    });
    std::vector<std::uint8_t> has_sharp(scene_.objects.size(), 0);
    for (const auto& objects : sharp_objects) {
      for (const std::size_t object : objects) has_sharp[object] = 1;
    }
    const double averaged = cosine(kAveragedDegrees);
    parallel_for(blocks, [&](std::size_t block) {
      for (const auto& [a, b] : smooth[block]) {
        if (has_sharp[object_of(a.face)] || bend(a, b) >= averaged) mark(a, b, kCornerSmooth);
      }
    });
  }

 private:
  enum class FileVerdict { nothing, smooth, sharp };

  /// Computes the normal of each face, and whether the file's normal at each of its corners is parallel to it. The sign
  /// is ignored: files disagree on the orientation of faces.
  void measure_faces() {
    const std::vector<std::uint32_t>& shaded = shading_.corner_normals;
    normals_.resize(scene_.faces.size());
    is_flat_.resize(shaded.size(), 0);
    const double flat = cosine(kFlatShadingDegrees);
    parallel_each(normals_.size(), [&](std::size_t f) {
      normals_[f] = face_normal(scene_, static_cast<std::uint32_t>(f));
      if (shaded.empty()) return;
      for (std::size_t k = scene_.faces.corner_index(f, 0); k < scene_.faces.corner_index(f + 1, 0); ++k) {
        if (shaded[k] == 0) continue;
        const Point3 direction = unpacked_direction(shaded[k]);
        const double d = glm::dot(direction, normals_[f]);
        is_flat_[k] = d * d >= flat * flat * glm::dot(direction, direction);
      }
    });
  }

  std::size_t object_of(std::uint32_t face) const {
    const auto after = std::upper_bound(scene_.objects.begin(), scene_.objects.end(), face,
                                        [](std::uint32_t f, const Object& object) { return f < object.face_end; });
    return static_cast<std::size_t>(after - scene_.objects.begin());
  }

  /// Whether both sides run in the same direction: then the windings of their faces disagree.
  bool same_way(const Side& a, const Side& b) const {
    const auto corners = std::as_const(scene_.faces).corners();
    return scene_.vertices[corners[a.corner]] == scene_.vertices[corners[b.corner]];
  }

  /// Cosine of the angle between the faces' normals.
  double bend(const Side& a, const Side& b) const {
    return glm::dot(normals_[a.face], normals_[b.face]) * (same_way(a, b) ? -1 : 1);
  }

  FileVerdict verdict_at(const Side& a, const Side& b) const {
    if (!shading_.corner_normals.empty()) {
      const auto& n = shading_.corner_normals;
      if (n[a.corner] && n[a.next] && n[b.corner] && n[b.next]) return by_normals(a, b);
    }
    return shading_.face_groups.empty() ? FileVerdict::nothing : by_groups(a.face, b.face);
  }

  FileVerdict by_normals(const Side& a, const Side& b) const {
    const auto& n = shading_.corner_normals;
    if (is_flat(a) && is_flat(b)) return FileVerdict::nothing;
    const bool like = same_way(a, b);
    const std::uint32_t at_start = like ? b.corner : b.next, at_end = like ? b.next : b.corner;
    return within(n[a.corner], n[at_start], same_) || within(n[a.next], n[at_end], same_) ? FileVerdict::smooth
                                                                                          : FileVerdict::sharp;
  }

  bool is_flat(const Side& side) const { return is_flat_[side.corner] && is_flat_[side.next]; }

  FileVerdict by_groups(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t p = shading_.face_groups[a], q = shading_.face_groups[b];
    if (p == 0 && q == 0) return FileVerdict::nothing;
    return (shading_.groups_are_bits ? (p & q) != 0 : p == q) ? FileVerdict::smooth : FileVerdict::sharp;
  }

  void mark(const Side& a, const Side& b, std::uint8_t flag) {
    scene_.corner_flags[a.corner] |= flag;
    scene_.corner_flags[b.corner] |= flag;
  }

  Scene& scene_;
  const FileShading& shading_;
  Sides sides_;
  std::vector<Point3> normals_;        ///< per face
  std::vector<std::uint8_t> is_flat_;  ///< per corner: the file's normal is that of the face
  const double same_ = cosine(kSameDegrees);
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
  const auto level = [&](unsigned shift) { return 2.0 * static_cast<double>(packed >> shift & kLevels) - kLevels; };
  return {level(20), level(10), level(0)};
}

std::optional<Weld> mark_smooth_edges(Scene& scene, const FileShading& shading) {
  const auto has_no_verdict = [](const std::vector<std::uint32_t>& marks) {
    return std::all_of(marks.begin(), marks.end(), [](std::uint32_t one) { return one == 0; });
  };
  if (has_no_verdict(shading.corner_normals) && has_no_verdict(shading.face_groups)) return std::nullopt;
  Weld weld = weld_vertices(scene);
  Marker(scene, shading).run(weld);
  return weld;
}

}  // namespace ligne
