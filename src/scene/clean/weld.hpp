#pragma once
/// Finding the vertices of an object that have equal positions.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// The vertex that stands for each vertex after welding.
struct Weld {
  /// Per vertex: the first vertex of its object at the same position (itself, most often), or kNone when a coordinate is
  /// not finite.
  std::vector<std::uint32_t> first;
  std::size_t repeated = 0;    ///< vertices that another one stands for
  std::size_t not_finite = 0;  ///< vertices with a coordinate that is not finite

  bool changes_nothing() const { return repeated == 0 && not_finite == 0; }
};

/// Compares positions exactly, -0 as +0. Objects must own ascending ranges that cover all vertices.
Weld weld_vertices(const Scene& scene);

}  // namespace ligne
