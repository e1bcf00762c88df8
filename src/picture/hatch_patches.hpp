#pragma once
/// Faces that hang together smoothly, for hatching.

#include <cstdint>
#include <vector>

#include "scene/model/topology.hpp"

namespace ligne {

/// Faces that are one surface: their common edges are no creases. Strokes continue over them, and end at the rims of
/// patches.
struct HatchPatches {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};
HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees);

}  // namespace ligne
