#include "scene/heal/close_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/heal/merge_ends.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Largest height of a step, by the diagonal of its object: 1/60 mm on A4, a twentieth of a line.
constexpr double kStepPart = 1.0 / 16384;
/// Least length of a needle, by its short side: those of slivers (docs/numerics.md).
constexpr double kNeedleLength = 8;
/// Least number of needles in the steps of an object: a curved surface that is made of pieces has a step at each of a dozen
/// facets or more.
constexpr std::size_t kFewestInSteps = 12;
/// Least part of the faces of the object that these are: CAD programs leave single such needles in free forms.
constexpr double kLeastPart = 1.0 / 256;
/// Most needles of a step.
constexpr std::size_t kMostNeedles = 16;
/// Least and largest bend between the faces on both sides of a step, radians: below the first they are one plane, and above
/// the second no facets of one surface (kLargestBend).
constexpr double kLeastBend = 0.5 * std::numbers::pi / 180, kMostBend = 31 * std::numbers::pi / 180;
/// Least bend of the needles of a step to either side, radians: planes have a crease there.
constexpr double kSharpBend = 10 * std::numbers::pi / 180;

using Side = std::array<std::uint32_t, 2>;

/// A face of three or four corners between two long sides, each in the direction of its contour.
struct Needle {
  std::uint32_t face = kNone;
  std::array<Side, 2> longs{};
  std::vector<Side> shorts{};
  double width = 0;  ///< half the length of its short sides: the mean distance of the long ones
};

std::optional<Needle> needle_at(const Scene& scene, std::uint32_t face, double most) {
  if (scene.faces.contour_count(face) != 1) return std::nullopt;
  const auto contour = scene.faces.contour(face, 0);
  if (contour.size() > 4) return std::nullopt;
  std::array<std::size_t, 2> longs{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const std::uint32_t next = contour[(k + 1) % contour.size()];
    if (are_within(most, scene.vertices[contour[k]], scene.vertices[next])) continue;
    if (count == longs.size()) return std::nullopt;
    longs[count++] = k;
  }
  const bool are_opposite = contour.size() == 3 || longs[1] - longs[0] == 2;
  if (count != longs.size() || !are_opposite) return std::nullopt;
  Needle needle{face};
  double least = std::numeric_limits<double>::infinity(), widest = 0;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const Side side{contour[k], contour[(k + 1) % contour.size()]};
    const double length = glm::distance(scene.vertices[side[0]], scene.vertices[side[1]]);
    if (k == longs[0] || k == longs[1]) {
      needle.longs[k == longs[0] ? 0 : 1] = side;
      least = std::min(least, length);
    } else {
      needle.shorts.push_back(side);
      needle.width += length / 2;
      widest = std::max(widest, length);
    }
  }
  if (least < kNeedleLength * widest) return std::nullopt;
  return needle;
}

/// The least number of needles in the steps of an object.
std::size_t fewest_in_steps(const Object& object) {
  return std::max(kFewestInSteps, static_cast<std::size_t>(kLeastPart * (object.face_end - object.face_begin)));
}

/// The steps of one object.
class StepFinder {
 public:
  StepFinder(const Scene& scene, const Object& object, std::vector<Needle> needles, double most)
      : scene_(scene),
        error_(kSqrt3 * object.precision),
        most_(most),
        fewest_(fewest_in_steps(object)),
        needles_(std::move(needles)) {
    std::vector<std::uint8_t> marked(object.vertex_end - object.vertex_begin);
    for (std::uint32_t n = 0; n < needles_.size(); ++n) {
      needle_of_[needles_[n].face] = n;
      for (const std::uint32_t v : scene.faces.contour(needles_[n].face, 0)) marked[v - object.vertex_begin] = 1;
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      for_sides(scene.faces, f, [&](std::uint32_t from, std::uint32_t to) {
        if (!marked[from - object.vertex_begin] || !marked[to - object.vertex_begin]) return;
        std::uint32_t& stored = face_of_[key({from, to})];
        stored = stored == kNone ? f : kSeveral;
      });
    }
  }

  /// Appends the short sides of all steps, if these are many.
  void run(std::vector<Side>& shorts) const {
    std::vector<Side> found;
    std::size_t count = 0;
    for (const Needle& needle : needles_) {
      const End first = end_of(needle, 0), last = end_of(needle, 1);
      if (needle.width + first.width + last.width > most_ || !is_step_between(first, last)) continue;
      found.insert(found.end(), needle.shorts.begin(), needle.shorts.end());
      ++count;
    }
    if (count >= fewest_) shorts.insert(shorts.end(), found.begin(), found.end());
  }

 private:
  /// An end of a run of needles.
  struct End {
    std::uint32_t face = kNone;     ///< the face behind it, or kNone if there is none
    double width = 0;               ///< of the needles on the way
    double convex = 0, hollow = 0;  ///< largest bends on the way, radians
  };

  static std::uint64_t key(const Side& side) { return std::uint64_t(side[0]) << 32 | side[1]; }

  /// The face on the other side of a long side.
  std::uint32_t beyond(const Side& side) const {
    const std::uint32_t face = face_of_.find(key({side[1], side[0]}));
    return face == kSeveral || face_of_.find(key(side)) == kSeveral ? kNone : face;
  }

  /// Walks from a needle over the next ones.
  End end_of(const Needle& needle, std::size_t way) const {
    End end;
    Side side = needle.longs[way];
    std::uint32_t face = needle.face;
    for (std::size_t i = 0; i < kMostNeedles; ++i) {
      const std::uint32_t other = beyond(side);
      if (other == kNone) return {};
      add_bend(face, other, side, end);
      face = other;
      const std::uint32_t next = needle_of_.find(face);
      if (next == kNone) {
        end.face = face;
        return end;
      }
      const Side back{side[1], side[0]};
      const auto& longs = needles_[next].longs;
      if (longs[0] != back && longs[1] != back) return {};
      end.width += needles_[next].width;
      side = longs[longs[0] == back ? 1 : 0];
    }
    return {};
  }

  /// Adds the bend between two faces, but for what rounding may have turned them by.
  void add_bend(std::uint32_t face, std::uint32_t other, const Side& side, End& end) const {
    const Point3 along = scene_.vertices[side[1]] - scene_.vertices[side[0]];
    const double length = glm::length(along);
    const Point3 a = double_area(scene_, face), b = double_area(scene_, other);
    const double least = std::min(glm::length(a), glm::length(b)) / length;
    const double bend = std::atan2(glm::dot(glm::cross(a, b), along), glm::dot(a, b) * length);
    const double sure = std::abs(bend) - std::atan2(2 * error_, least);
    double& most = bend > 0 ? end.convex : end.hollow;
    most = std::max(most, sure);
  }

  /// Whether the faces at both ends go on as one curved surface, while the needles between them bend to both sides.
  bool is_step_between(const End& first, const End& last) const {
    if (first.face == kNone || last.face == kNone || first.face == last.face) return false;
    const Point3 a = double_area(scene_, first.face), b = double_area(scene_, last.face);
    const double bend = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    return bend >= kLeastBend && bend <= kMostBend && std::max(first.convex, last.convex) >= kSharpBend &&
           std::max(first.hollow, last.hollow) >= kSharpBend;
  }

  static constexpr std::uint32_t kSeveral = kNone - 1;

  const Scene& scene_;
  double error_, most_;
  std::size_t fewest_;  ///< needles in steps
  std::vector<Needle> needles_;
  KeyTable needle_of_;  ///< by face
  KeyTable face_of_;    ///< by directed side; kSeveral if not unique
};

std::vector<Needle> needles_of(const Scene& scene, std::span<const std::uint32_t> faces, double most) {
  std::vector<std::vector<Needle>> found(block_count(faces.size(), kShortWorkBlock));
  parallel_blocks(faces.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t f : faces.subspan(begin, end - begin)) {
      if (auto needle = needle_at(scene, f, most)) found[begin / kShortWorkBlock].push_back(std::move(*needle));
    }
  });
  std::vector<Needle> all;
  for (auto& block : found) std::ranges::move(block, std::back_inserter(all));
  return all;
}

std::vector<Side> joined(const std::vector<std::vector<Side>>& lists) {
  std::vector<Side> all;
  for (const std::vector<Side>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// For each object, the numbers of its edges of one face and of more than two.
std::vector<std::array<std::size_t, 2>> unpaired_edges(const Scene& scene) {
  const Topology topology = build_topology(scene);
  std::vector<std::array<std::size_t, 2>> unpaired;
  for (const Object& object : scene.objects) {
    const EdgeRange edges = edges_of(topology, object);
    const auto flags = std::span(topology.edge_flags).subspan(edges.begin, edges.end - edges.begin);
    const auto count = [&](std::uint16_t flag) {
      return static_cast<std::size_t>(std::ranges::count_if(flags, [=](std::uint16_t f) { return (f & flag) != 0; }));
    };
    unpaired.push_back({count(kEdgeBorder), count(kEdgeManyFaces)});
  }
  return unpaired;
}

}  // namespace

NarrowFaces find_narrow_faces(const Scene& scene, double roundings) {
  NarrowFaces narrow;
  for (const Object& object : scene.objects) {
    double height = 0;
    if (object.vertex_begin < object.vertex_end) {
      const auto [low, high] = bounds_of(scene, object.vertex_begin, object.vertex_end);
      height = kStepPart * glm::distance(low, high);
    }
    narrow.step_heights.push_back(height);
    narrow.faces.push_back(narrow_faces(scene, object, std::max(height, roundings * object.precision)));
  }
  return narrow;
}

std::size_t close_steps(Scene& scene, const NarrowFaces& narrow) {
  const std::vector<double>& most = narrow.step_heights;
  std::vector<std::vector<Side>> shorts(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (narrow.faces[i].size() < fewest_in_steps(object)) continue;
    std::vector<Needle> needles = needles_of(scene, narrow.faces[i], most[i]);
    if (needles.size() >= fewest_in_steps(object)) StepFinder(scene, object, std::move(needles), most[i]).run(shorts[i]);
  }
  std::vector<Side> all = joined(shorts);
  if (all.empty()) return 0;
  const Scene stored = scene;
  const std::size_t merged = merge_ends(scene, all, most);
  const auto before = unpaired_edges(stored), after = unpaired_edges(scene);
  const auto is_worse = [&](std::size_t i) { return after[i][0] > before[i][0] || after[i][1] > before[i][1]; };
  bool any = false;
  for (std::size_t i = 0; i < shorts.size(); ++i) {
    if (!is_worse(i)) continue;
    shorts[i].clear();
    any = true;
  }
  if (!any) return merged;
  scene = stored;
  return merge_ends(scene, joined(shorts), most);
}

}  // namespace ligne
