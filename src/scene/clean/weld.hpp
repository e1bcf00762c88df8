#pragma once
/// Welds the vertices of an object that have equal positions, or near ones.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// The vertex that replaces each vertex after welding.
struct Weld {
  /// Per vertex: the first vertex of its object at its position (mostly the vertex itself), or kNone if a coordinate is
  /// not finite.
  std::vector<std::uint32_t> first;
  std::size_t repeated = 0;    ///< number of vertices that another one replaces
  std::size_t not_finite = 0;  ///< vertices with a coordinate that is not finite

  bool changes_nothing() const { return repeated == 0 && not_finite == 0; }
};

/// Compares positions exactly; -0 equals +0. Objects must own ascending ranges that cover all vertices.
Weld weld_vertices(const Scene& scene);

/// Merges the positions of vertices of one object that lie within `distance` (model units, positive) of each other.
/// Each vertex moves onto an earlier vertex that is near enough and has not moved itself. So no vertex moves by more
/// than `distance`, and vertices that stay apart are farther apart than that. The result depends on the order of the
/// vertices alone. Takes time proportional to the number of vertices. Vertices that are not finite stay unchanged.
/// Objects must own ascending ranges, or there must be none.
void weld_near_vertices(Scene& scene, double distance);

}  // namespace ligne
