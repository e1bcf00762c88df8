#include "scene/contacts/chord_errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Largest ratio of the widths of two faces that are chords of one arc. A wider face is a flat side beside a narrow
/// fillet, and lies as near to its shape as the fillet does. Adjustable.
constexpr double kUneven = 4;

/// Distance from an edge of the face to its farthest vertex, across the edge. `normal` is that of the face.
double width_from(const Scene& scene, std::uint32_t face, const Point3& normal, std::uint32_t v0, std::uint32_t v1) {
  const Point3 origin = scene.vertices[v0];
  const Point3 across = glm::cross(normal, glm::normalize(scene.vertices[v1] - origin));
  double width = 0;
  for (const std::uint32_t v : corners_of(scene.faces, face))
    width = std::max(width, std::abs(glm::dot(scene.vertices[v] - origin, across)));
  return width;
}

struct Extent {
  double low = 0, high = 0;
};

Extent extent(const Scene& scene, std::uint32_t face, const Point3& origin, const Point3& direction) {
  Extent e;
  for (const std::uint32_t v : scene.faces.contour(face, 0)) {
    const double at = glm::dot(scene.vertices[v] - origin, direction);
    e.low = std::min(e.low, at);
    e.high = std::max(e.high, at);
  }
  return e;
}

}  // namespace

ChordErrors::ChordErrors(const Scene& scene, const FaceNeighbours& neighbours, std::vector<std::uint32_t> faces,
                         double smooth_degrees)
    : faces_(std::move(faces)), errors_(faces_.size(), 0), bends_(faces_.size(), 0) {
  neighbours.for_each_pair([&](std::uint32_t a, std::uint32_t b, std::uint32_t v0, std::uint32_t v1) {
    add(scene, a, b, v0, v1, smooth_degrees);
    add(scene, b, a, v0, v1, smooth_degrees);
  });
}

void ChordErrors::add(const Scene& scene, std::uint32_t face, std::uint32_t neighbour, std::uint32_t v0, std::uint32_t v1,
                      double smooth_degrees) {
  const auto place = std::lower_bound(faces_.begin(), faces_.end(), face);
  if (place == faces_.end() || *place != face) return;
  const Point3 n = face_normal(scene, face), m = face_normal(scene, neighbour);
  if (n == Point3(0) || m == Point3(0)) return;
  // |n - m| = 2 sin(t/2), and tan(t/4) = sin(t/2) / (1 + cos(t/2)).
  const double sine = glm::length(n - m) / 2;
  if (sine > sine_cosine_degrees(smooth_degrees / 2).sine) return;
  double width = width_from(scene, face, n, v0, v1);
  const double beside = width_from(scene, neighbour, m, v0, v1);
  const auto at = static_cast<std::size_t>(place - faces_.begin());
  if (width > kUneven * beside) {
    width = beside;
  } else {
    bends_[at] = std::max(bends_[at], 2 * std::asin(sine));
  }
  double& error = errors_[at];
  error = std::max(error, width / 2 * sine / (1 + std::sqrt(1 - sine * sine)));
}

std::size_t ChordErrors::place_of(std::uint32_t face) const {
  return static_cast<std::size_t>(std::lower_bound(faces_.begin(), faces_.end(), face) - faces_.begin());
}

double ChordErrors::of(std::uint32_t face) const { return errors_[place_of(face)]; }

double ChordErrors::bend(std::uint32_t face) const { return bends_[place_of(face)]; }

FaceNeighbours::FaceNeighbours(const Scene& scene, const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint8_t> at_face(scene.vertices.size(), 0);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : corners_of(scene.faces, f)) at_face[v] = 1;
  }
  for (const Object& object : scene.objects) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), object.face_begin);
    if (first == faces.end() || *first >= object.face_end) continue;
    const std::uint32_t count = object.face_end - object.face_begin;
    std::vector<std::vector<EdgeUse>> found(block_count(count, kShortWorkBlock));
    parallel_blocks(count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto f = static_cast<std::uint32_t>(object.face_begin + i);
        for_sides(scene.faces, f, [&](std::uint32_t v, std::uint32_t w) {
          if (at_face[v] && at_face[w]) found[begin / kShortWorkBlock].push_back({std::min(v, w), std::max(v, w), f});
        });
      }
    });
    for (const std::vector<EdgeUse>& block : found) uses_.insert(uses_.end(), block.begin(), block.end());
  }
  std::sort(uses_.begin(), uses_.end());
}

std::uint32_t FaceNeighbours::across(std::uint32_t face, std::uint32_t v, std::uint32_t w) const {
  const EdgeUse key{std::min(v, w), std::max(v, w), 0};
  const auto first = std::lower_bound(uses_.begin(), uses_.end(), key);
  if (first == uses_.end() || first->edge() != key.edge()) return kNone;
  const auto begin = static_cast<std::size_t>(first - uses_.begin());
  if (end_of_edge(begin) - begin != 2) return kNone;
  return uses_[begin].face == face ? uses_[begin + 1].face : uses_[begin].face;
}

double object_precision(const Scene& scene, std::uint32_t face) {
  return std::ranges::upper_bound(scene.objects, face, {}, &Object::face_end)->precision;
}

bool within_distance(const Scene& scene, const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment,
                     double distance) {
  const Point3 n = face_normal(scene, faces[0]), m = face_normal(scene, faces[1]);
  const Point3 line = glm::cross(n, m);
  const double sine = glm::length(line);
  if (sine == 0) return true;  // parallel planes that meet
  // Directions in the two faces, away from the segment and to the same side of it.
  const Point3 along_n = glm::cross(line / sine, n);
  Point3 along_m = glm::cross(line / sine, m);
  if (glm::dot(along_n, along_m) < 0) along_m = -along_m;
  const Extent a = extent(scene, faces[0], segment[0], along_n), b = extent(scene, faces[1], segment[0], along_m);
  const double width = std::max(std::min(a.high, b.high), std::min(-a.low, -b.low));
  return width * sine <= distance;
}

}  // namespace ligne
