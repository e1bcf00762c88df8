#pragma once
/// Fillets: narrow strips of a cylinder or a torus that join two surfaces smoothly.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// A polyline on the mesh: segment i runs from point i to point i + 1 across face faces[i]. A closed line repeats its
/// first point.
struct FaceLine {
  std::vector<Point3> points;
  std::vector<std::uint32_t> faces;
  bool closed = false;
};

struct FilletMiddles {
  std::vector<std::uint8_t> is_fillet;  ///< per patch
  std::vector<FaceLine> lines;          ///< along their middles
};

/// Finds the fillets that are at most `widest` wide, and the lines along their middles on the faces of the mesh. The
/// width is measured in model units along the arc across the fillet. A fillet of a circular edge is a strip of a torus.
/// The small sphere at a corner where fillets meet is a fillet too: the lines continue to its middle. `edges` are those
/// of classify_patch_edges().
FilletMiddles fillet_middles(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const PatchEdge> edges, double widest);

}  // namespace ligne
