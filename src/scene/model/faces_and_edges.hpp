#pragma once
/// Corners, sides and areas of faces; lengths and neighbours of edges.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

#include "base/no_index.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The corners of a face, those of its holes too.
inline std::span<const std::uint32_t> corners_of(const PolygonFaces& faces, std::size_t f) {
  if (faces.all_triangles()) return faces.contour(f, 0);
  return faces.corners().subspan(faces.corner_index(f, 0), faces.corner_index(f + 1, 0) - faces.corner_index(f, 0));
}

/// Calls visit(from, to) for the sides of a face, those of its holes too, in the direction of its contours.
template <class Visit>
void for_sides(const PolygonFaces& faces, std::size_t f, const Visit& visit) {
  for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
    const auto contour = faces.contour(f, c);
    for (std::size_t k = 0; k + 1 < contour.size(); ++k) visit(contour[k], contour[k + 1]);
    visit(contour.back(), contour[0]);
  }
}

inline bool is_triangle(const PolygonFaces& faces, std::size_t f) {
  return faces.contour_count(f) == 1 && faces.contour(f, 0).size() == 3;
}

/// Largest distance of a corner of a face from its first one.
inline double face_span(const Scene& scene, std::uint32_t face) {
  const auto contour = scene.faces.contour(face, 0);
  double most = 0;
  for (const std::uint32_t v : contour) most = std::max(most, glm::distance(scene.vertices[v], scene.vertices[contour[0]]));
  return most;
}

/// The normal of a face, with twice its area as length, square model units; holes are subtracted.
inline Point3 double_area(const Scene& scene, std::uint32_t face) {
  Point3 sum(0, 0, 0);
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto contour = scene.faces.contour(face, c);
    const Point3& a = scene.vertices[contour[0]];
    for (std::size_t k = 2; k < contour.size(); ++k) {
      sum += glm::cross(scene.vertices[contour[k - 1]] - a, scene.vertices[contour[k]] - a);
    }
  }
  return sum;
}

inline double edge_length(const Scene& scene, const Edge& edge) {
  return glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
}

/// The end of an edge that is not `vertex`.
inline std::uint32_t other_end(const Edge& edge, std::uint32_t vertex) { return edge.v0 == vertex ? edge.v1 : edge.v0; }

/// The face at an edge of two that is not `face`.
inline std::uint32_t other_face(const Edge& edge, std::uint32_t face) {
  return edge.face0 == face ? edge.face1 : edge.face0;
}

/// The number of the edge between two vertices; kNone if there is none.
inline std::uint32_t edge_between(const Topology& topology, std::uint32_t v, std::uint32_t w) {
  const Edge* edge = find_edge(topology, {v, w});
  return edge ? static_cast<std::uint32_t>(edge - topology.edges.data()) : kNone;
}

}  // namespace ligne
