#pragma once
/// Faces without area, and the neighbours whose planes they take.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The face across the longest edge of another one.
struct LongestNeighbour {
  double length = -1;  ///< of the edge, model units
  std::uint32_t face = kNone;
  bool turned = false;  ///< it is wound the other way
};

enum class FlatNeighbours { taken, passed_over };

/// Per flat face that has neighbours, the one across its longest edge; of equal edges the first in the topology.
/// `flat`: per face of the scene, not zero if it has no area. `FlatNeighbours` says whether a neighbour may be flat itself.
std::unordered_map<std::uint32_t, LongestNeighbour> longest_neighbours(const Scene& scene, const Topology& topology,
                                                                       const std::vector<std::uint8_t>& flat,
                                                                       FlatNeighbours flat_neighbours);

}  // namespace ligne
