#pragma once
/// Traces the creases of scans and remeshed surfaces as lines along ridges, without the teeth of single triangles.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/scan_meshes.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct TracedCreases {
  std::vector<ScanObject> scans;  ///< in ascending order
  std::size_t left_out = 0;       ///< edges that bend by more than the crease angle, but lie on no clean line
  std::size_t continued = 0;      ///< edges that bend by less, but lie on a clean line
};

/// In evenly meshed objects (docs/clear-lines.md, "Scans"), sets the bends of edges on no clean line to none, and those
/// of edges on a clean line to strong. Other objects stay unchanged. `normals` are those of face_normals(), `sizes` the
/// extents of the objects.
TracedCreases trace_creases(const Scene& scene, const Topology& topology, const std::vector<glm::vec3>& normals,
                            std::span<const double> sizes, double crease_degrees, std::vector<Bend>& bends);

}  // namespace ligne
