#pragma once
/// The circles at which recognised surfaces end.

#include <vector>

#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

struct PatchCircle {
  Point3 centre{0, 0, 0}, axis{0, 0, 1};  ///< axis: unit length
  double radius = 0;
};

/// The circles about the axes of patches on which the edges between a patch and other faces lie, each once. They are known
/// as exactly as the surfaces, however few corners a mesh has on them.
std::vector<PatchCircle> patch_circles(const Scene& scene, const Topology& topology, const Patches& patches);

}  // namespace ligne
