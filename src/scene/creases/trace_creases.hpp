#pragma once
/// Traces the creases of scans and remeshed surfaces as lines along ridges, without the teeth of single triangles.

#include <cstddef>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/scan_meshes.hpp"

namespace ligne {

struct TracedCreases {
  std::vector<ScanObject> scans;  ///< in ascending order, with decimated objects
  std::size_t decimated = 0;      ///< number of the latter
  std::size_t left_out = 0;       ///< edges that bend by more than the crease angle, but lie on no clean line
  std::size_t continued = 0;      ///< edges that bend by less, but lie on a clean line
};

/// In evenly meshed and in decimated objects (docs/clear-lines.md, "Scans"), sets the bends of edges on no clean line to
/// none, and those of edges on a clean line to strong. Other objects stay unchanged, and so do those creases of decimated
/// ones that have recognised surfaces on both sides.
TracedCreases trace_creases(const CreaseMesh& mesh, double crease_degrees, std::vector<Bend>& bends);

}  // namespace ligne
