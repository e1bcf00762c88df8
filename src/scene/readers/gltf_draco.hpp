#pragma once
/// Meshes compressed by KHR_draco_mesh_compression.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// The positions and triangles of a compressed primitive; every corner is below positions.size().
struct DracoMesh {
  std::vector<Point3> positions;
  std::vector<std::uint32_t> corners;  ///< three per triangle
  double largest = 0;                  ///< largest coordinate, without sign
};

/// Decodes a mesh whose positions are the attribute of that unique id. Throws InputError(name, place + cause); always does
/// when the program was built without libdraco.
DracoMesh decode_draco(std::span<const std::byte> bytes, int position_id, const std::string& name, const std::string& place);

}  // namespace ligne
