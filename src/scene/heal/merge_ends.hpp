#pragma once
/// Merges the ends of short edges.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// Whether two points are less than a distance apart.
inline bool are_within(double distance, const Point3& p, const Point3& q) {
  // Nearly all edges are long in each direction.
  if (!(std::abs(p.x - q.x) < distance)) return false;
  const Point3 way = p - q;
  return glm::dot(way, way) < distance * distance;
}

/// The faces of an object that may have an edge shorter than a distance, ascending: triangles that have one, and all faces
/// of a scene that has others than triangles. O(n).
std::vector<std::uint32_t> narrow_faces(const Scene& scene, const Object& object, double distance);

/// Merges the ends of edges, and drops the faces that vanish. Over a chain of edges, vertices of object i merge with the
/// first one where they are less than distances[i] from it. Returns the number of vertices that were merged. Takes O(n)
/// time.
std::size_t merge_ends(Scene& scene, std::span<const std::array<std::uint32_t, 2>> edges, std::span<const double> distances);

}  // namespace ligne
