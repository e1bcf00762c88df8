#pragma once
/// Merges the ends of short edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

#include "base/prefetch.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Whether two points are less than a distance apart.
inline bool are_within(double distance, const Point3& p, const Point3& q) {
  // Nearly all edges are long in each direction.
  if (!(std::abs(p.x - q.x) < distance)) return false;
  const Point3 way = p - q;
  return glm::dot(way, way) < distance * distance;
}

/// Whether a scene consists of triangles, and triangle f has no edge shorter than a distance. Nearly all have none.
/// Prefetches the corners of one of the next triangles.
inline bool is_long_triangle(const Scene& scene, std::size_t f, double distance) {
  if (!scene.faces.all_triangles()) return false;
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  prefetch_corners(scene.vertices, corners, f);
  const auto corner = [&](std::size_t k) -> const Point3& { return scene.vertices[corners[3 * f + k]]; };
  const Point3 &a = corner(0), &b = corner(1), &c = corner(2);
  // Most edges are long in the direction of x.
  const double least = std::min(std::min(std::abs(a.x - b.x), std::abs(b.x - c.x)), std::abs(c.x - a.x));
  return least >= distance || (!are_within(distance, a, b) && !are_within(distance, b, c) && !are_within(distance, c, a));
}

/// Merges the ends of edges, and drops the faces that vanish. Over a chain of edges, vertices of object i merge with the
/// first one where they are less than distances[i] from it. Returns the number of vertices that were merged. Takes O(n)
/// time.
std::size_t merge_ends(Scene& scene, std::span<const std::array<std::uint32_t, 2>> edges, std::span<const double> distances);

}  // namespace ligne
