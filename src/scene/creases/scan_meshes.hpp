#pragma once
/// Recognises objects that are meshed like scans.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// An object that is meshed like a scan, with its edges in the topology.
struct ScanObject {
  std::uint32_t face_begin = 0, face_end = 0;
  std::uint32_t edge_begin = 0, edge_end = 0;
};

/// Whether the mesh of an object looks like a scan or a remeshed surface: without planes and without vertices placed on
/// its corners. `normals` are those of face_normals(), `bends` the classes of the edges by their angles, and `precision`
/// is that of the object's coordinates.
bool is_scan(const Scene& scene, const Topology& topology, const std::vector<glm::vec3>& normals,
             const std::vector<Bend>& bends, const ScanObject& object, double precision);

}  // namespace ligne
