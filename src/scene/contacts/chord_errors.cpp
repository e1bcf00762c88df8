#include "scene/contacts/chord_errors.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/degrees.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Largest ratio of the widths of two faces that are chords of one arc. A wider face is a flat side beside a narrow
/// rounding, and lies as near to its shape as the rounding does. Adjustable.
constexpr double kUneven = 4;

/// Distance from an edge of the face to its farthest vertex, across the edge. `normal` is that of the face.
double width_from(const Scene& scene, std::uint32_t face, const Point3& normal, std::uint32_t v0, std::uint32_t v1) {
  const Point3 origin = scene.vertices[v0];
  const Point3 across = glm::cross(normal, glm::normalize(scene.vertices[v1] - origin));
  double width = 0;
  for_each_edge(scene, face, [&](std::uint32_t v, std::uint32_t) {
    width = std::max(width, std::abs(glm::dot(scene.vertices[v] - origin, across)));
  });
  return width;
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

}  // namespace ligne
