#pragma once
/// The shape of a face: whether it is convex, and the neighbours of faces without area.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Whether a face has no hole and turns to one side at all its corners. Straight corners do not count, nor do turns within
/// `tolerance`, a length in model units. O(corners).
bool is_convex_face(const Scene& scene, std::uint32_t face, double tolerance);

/// The neighbour of a face across its longest edge.
struct LongestNeighbour {
  double length = -1;  ///< of the edge, model units
  std::uint32_t face = kNone;
  bool turned = false;  ///< whether its winding is opposite
};

/// Whether a neighbour may have no area itself: yes, or no.
enum class FlatNeighbours { taken, passed_over };

/// Maps each flat face that has neighbours to the one across its longest edge. Among edges of equal length, the first
/// in the topology counts. `flat`: per face of the scene, not zero if it has no area.
std::unordered_map<std::uint32_t, LongestNeighbour> longest_neighbours(const Scene& scene, const Topology& topology,
                                                                       const std::vector<std::uint8_t>& flat,
                                                                       FlatNeighbours flat_neighbours);

}  // namespace ligne
