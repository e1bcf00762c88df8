#pragma once
/// Merges the ends of short edges.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/model/scene.hpp"

namespace ligne {

/// Whether two points are less than a distance apart.
bool are_within(double distance, const Point3& p, const Point3& q);

/// Merges the ends of edges, and drops the faces that vanish. Over a chain of edges, vertices of object i merge with the
/// first one where they are less than distances[i] from it. Returns the number of vertices that were merged. Takes O(n)
/// time.
std::size_t merge_ends(Scene& scene, std::span<const std::array<std::uint32_t, 2>> edges, std::span<const double> distances);

}  // namespace ligne
