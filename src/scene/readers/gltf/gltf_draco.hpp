#pragma once
/// Meshes compressed by KHR_draco_mesh_compression.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Positions and triangles of a compressed primitive; every corner is below positions.size().
struct DracoMesh {
  std::vector<Point3> positions;
  std::vector<std::uint32_t> corners;                 ///< three per triangle
  double largest = 0;                                 ///< largest absolute coordinate
  double step = 0;                                    ///< distance of successive coordinates; 0 where they were not rounded
  std::map<std::string, std::vector<double>> joints;  ///< JOINTS_0, WEIGHTS_0 and so on, four numbers per position
  std::vector<double> coordinates;                    ///< of a texture, two per position; empty: none
};

/// Decodes a mesh with its attributes POSITION, JOINTS_n, WEIGHTS_n and TEXCOORD_n, given by their unique ids. Throws
/// InputError(name, place + cause); always does if the program was built without libdraco.
DracoMesh decode_draco(std::span<const std::byte> bytes, const std::map<std::string, int>& ids, const std::string& name,
                       const std::string& place);

}  // namespace ligne
