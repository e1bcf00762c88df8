#pragma once
/// Fillets: narrow strips of a cylinder or a torus between two surfaces that they run into.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/find_patches.hpp"
#include "scene/patches/patch_edges.hpp"

namespace ligne {

/// A polyline over faces: segment i runs from point i to point i + 1 over face i. A closed line repeats its first point.
struct FaceLine {
  std::vector<Point3> points;
  std::vector<std::uint32_t> faces;
  bool closed = false;
};

struct FilletMiddles {
  std::vector<std::uint8_t> is_fillet;  ///< per patch
  std::vector<FaceLine> lines;
};

/// The lines along the middle of fillets that are no wider than `widest` (model units, along the arc across them), on the
/// faces of the mesh. A fillet of a circular edge is a strip of a torus. Corners, where fillets meet on a small sphere, are
/// fillets too: there the lines go on to the middle of the sphere. `edges` are those of classify_patch_edges().
FilletMiddles fillet_middles(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const PatchEdge> edges, double widest);

}  // namespace ligne
