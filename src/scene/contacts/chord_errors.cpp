#include "scene/contacts/chord_errors.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "geometry/degrees.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

struct EdgeUse {
  std::uint32_t v0, v1, face;
  auto edge() const { return std::tie(v0, v1); }
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

template <class Visit>
void for_each_edge(const Scene& scene, std::uint32_t face, Visit visit) {
  for (std::uint32_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto contour = scene.faces.contour(face, c);
    for (std::size_t i = 0; i < contour.size(); ++i) visit(contour[i], contour[(i + 1) % contour.size()]);
  }
}

/// Uses of the edges that join two of the vertices of the faces, in the objects of the faces; by edge.
std::vector<EdgeUse> edge_uses(const Scene& scene, const std::vector<std::uint32_t>& faces) {
  std::vector<bool> at_face(scene.vertices.size(), false);
  for (const std::uint32_t f : faces) {
    for_each_edge(scene, f, [&](std::uint32_t v, std::uint32_t) { at_face[v] = true; });
  }
  std::vector<EdgeUse> uses;
  for (const Object& object : scene.objects) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), object.face_begin);
    if (first == faces.end() || *first >= object.face_end) continue;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      for_each_edge(scene, f, [&](std::uint32_t v, std::uint32_t w) {
        if (at_face[v] && at_face[w]) uses.push_back({std::min(v, w), std::max(v, w), f});
      });
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

}  // namespace

ChordErrors::ChordErrors(const Scene& scene, std::vector<std::uint32_t> faces, double smooth_degrees)
    : faces_(std::move(faces)), errors_(faces_.size(), 0) {
  const std::vector<EdgeUse> uses = edge_uses(scene, faces_);
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    end = begin + 1;
    while (end < uses.size() && uses[end].edge() == uses[begin].edge()) ++end;
    if (end - begin != 2) continue;
    const EdgeUse &a = uses[begin], &b = uses[begin + 1];
    add(scene, a.face, b.face, a.v0, a.v1, smooth_degrees);
    add(scene, b.face, a.face, a.v0, a.v1, smooth_degrees);
  }
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
  const Point3 origin = scene.vertices[v0], along = glm::normalize(scene.vertices[v1] - origin);
  const Point3 across = glm::cross(n, along);
  double width = 0;
  for_each_edge(scene, face, [&](std::uint32_t v, std::uint32_t) {
    width = std::max(width, std::abs(glm::dot(scene.vertices[v] - origin, across)));
  });
  double& error = errors_[static_cast<std::size_t>(place - faces_.begin())];
  error = std::max(error, width / 2 * sine / (1 + std::sqrt(1 - sine * sine)));
}

double ChordErrors::of(std::uint32_t face) const {
  const auto place = std::lower_bound(faces_.begin(), faces_.end(), face);
  return errors_[static_cast<std::size_t>(place - faces_.begin())];
}

}  // namespace ligne
