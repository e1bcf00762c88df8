#include "scene/patches/repeated_objects.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "base/hash.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Largest distance of a vertex from its place in a repetition, in precisions of the coordinates: half a last place of each
/// of both objects, and the error of the motion, which is that of three vertices.
constexpr double kMotionPrecisions = 6;
/// Largest ratio of the precisions of an object and its repetition. A surface holds within the precision of its corners, so
/// those of a much coarser object say less than the finer one would.
constexpr double kLikePrecision = 4;
/// Largest number of different shapes that are kept for one list of faces. It bounds the comparisons of a crowd of boxes
/// that differ in size.
constexpr std::size_t kMostShapes = 4;

/// Compares and hashes all of an object but the places of its vertices.
class Structure {
 public:
  Structure(const Scene& scene, const Topology& topology, const Object& object)
      : scene_(scene), topology_(topology), object_(object), edges_(edges_of(topology, object)) {}

  std::uint64_t hash() const {
    std::uint64_t key = 0;
    visit([&key](std::uint32_t number) {
      key = extend_hash(key, number);
      return true;
    });
    return key;
  }

  bool operator==(const Structure& other) const {
    std::vector<std::uint32_t> numbers;
    other.visit([&numbers](std::uint32_t number) {
      numbers.push_back(number);
      return true;
    });
    std::size_t next = 0;
    const bool is_prefix = visit([&](std::uint32_t n) { return next < numbers.size() && numbers[next++] == n; });
    return is_prefix && next == numbers.size();
  }

 private:
  /// Calls take(number) for all numbers that make the structure, until one returns false. Returns whether none did.
  template <class Take>
  bool visit(Take take) const {
    const std::uint32_t first = object_.vertex_begin;
    if (!take(object_.vertex_end - first) || !take(object_.face_end - object_.face_begin)) return false;
    for (std::uint32_t f = object_.face_begin; f < object_.face_end; ++f) {
      const std::size_t contours = scene_.faces.contour_count(f);
      if (!take(static_cast<std::uint32_t>(contours))) return false;
      for (std::size_t c = 0; c < contours; ++c) {
        const auto corners = scene_.faces.contour(f, c);
        if (!take(static_cast<std::uint32_t>(corners.size()))) return false;
        for (const std::uint32_t v : corners) {
          if (!take(v - first)) return false;
        }
      }
    }
    for (std::uint32_t e = edges_.begin; e < edges_.end; ++e) {
      if (!take(topology_.edge_flags[e])) return false;
    }
    return true;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  EdgeRange edges_;
};

/// A hash of the numbers of vertices and faces of an object.
std::uint64_t size_key(const Object& object) {
  return extend_hash(extend_hash(0, object.vertex_end - object.vertex_begin), object.face_end - object.face_begin);
}

std::span<const Point3> vertices_of(const Scene& scene, const Object& object) {
  return {scene.vertices.data() + object.vertex_begin, scene.vertices.data() + object.vertex_end};
}

/// Three vertices that span the object: the first, the one farthest from it, and the one farthest from the line through
/// both.
std::optional<std::array<std::size_t, 3>> spanning_vertices(std::span<const Point3> points) {
  if (points.size() < 3) return std::nullopt;
  const auto farthest = [&](auto distance) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (distance(points[i]) > distance(points[best])) best = i;
    }
    return best;
  };
  const Point3& a = points[0];
  const std::size_t b = farthest([&](const Point3& p) { return glm::dot(p - a, p - a); });
  const Point3 line = points[b] - a;
  const auto beside = [&](const Point3& p) {
    const Point3 across = glm::cross(p - a, line);
    return glm::dot(across, across);
  };
  const std::size_t c = farthest(beside);
  if (!(beside(points[c]) > 0)) return std::nullopt;
  return std::array<std::size_t, 3>{0, b, c};
}

/// A right-handed orthonormal frame on three points, not on a line.
std::array<Point3, 3> frame_on(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 x = glm::normalize(b - a);
  const Point3 z = glm::normalize(glm::cross(x, c - a));
  return {x, glm::cross(z, x), z};
}

/// The motion that takes the vertices of one object to those of another, if there is one.
std::optional<Similarity> motion_between(const Scene& scene, const Object& from, const Object& to) {
  const auto source = vertices_of(scene, from), target = vertices_of(scene, to);
  const auto three = spanning_vertices(source);
  if (!three) return std::nullopt;
  const auto [a, b, c] = *three;
  const double length = glm::distance(target[a], target[b]);
  if (!(glm::length(glm::cross(target[b] - target[a], target[c] - target[a])) > 0)) return std::nullopt;
  Similarity motion;
  motion.scale = length / glm::distance(source[a], source[b]);
  const auto left = frame_on(source[a], source[b], source[c]), right = frame_on(target[a], target[b], target[c]);
  for (int i = 0; i < 3; ++i) {
    motion.rows[static_cast<std::size_t>(i)] = right[0][i] * left[0] + right[1][i] * left[1] + right[2][i] * left[2];
  }
  motion.shift = target[a] - motion(source[a]);
  const double moved_precision = motion.scale * from.precision;
  if (std::max(moved_precision, to.precision) > kLikePrecision * std::min(moved_precision, to.precision))
    return std::nullopt;
  const double tolerance = kMotionPrecisions * std::max(moved_precision, to.precision);
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (!(glm::distance(motion(source[i]), target[i]) <= tolerance)) return std::nullopt;
  }
  return motion;
}

}  // namespace

Point3 Similarity::turned(const Point3& direction) const {
  return {glm::dot(rows[0], direction), glm::dot(rows[1], direction), glm::dot(rows[2], direction)};
}

std::vector<Repetition> find_repetitions(const Scene& scene, const Topology& topology) {
  const std::size_t n = scene.objects.size();
  // Only objects of the same numbers of vertices and faces need more than these for a key.
  std::vector<std::uint64_t> keys(n);
  for (std::size_t i = 0; i < n; ++i) keys[i] = size_key(scene.objects[i]);
  std::vector<std::uint64_t> sizes = keys;
  std::ranges::sort(sizes);
  parallel_tasks(n, [&](std::size_t i) {
    const auto [first, last] = std::equal_range(sizes.begin(), sizes.end(), keys[i]);
    if (last - first == 1) return;
    keys[i] = Structure(scene, topology, scene.objects[i]).hash();
  });
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
  std::vector<std::size_t> runs;  // of equal keys
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 || keys[order[i]] != keys[order[i - 1]]) runs.push_back(i);
  }
  runs.push_back(n);

  std::vector<Repetition> repetitions(n);
  parallel_tasks(runs.size() - 1, [&](std::size_t run) {
    std::vector<std::uint32_t> shapes;
    for (std::size_t k = runs[run]; k < runs[run + 1]; ++k) {
      const std::uint32_t i = order[k];
      const Object& object = scene.objects[i];
      repetitions[i].original = i;
      for (const std::uint32_t shape : shapes) {
        const Object& earlier = scene.objects[shape];
        const auto motion = motion_between(scene, earlier, object);
        if (!motion || !(Structure(scene, topology, earlier) == Structure(scene, topology, object))) continue;
        repetitions[i] = {shape, *motion};
        break;
      }
      if (repetitions[i].original == i && shapes.size() < kMostShapes) shapes.push_back(i);
    }
  });
  return repetitions;
}

}  // namespace ligne
