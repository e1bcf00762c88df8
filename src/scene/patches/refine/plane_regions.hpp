#pragma once
/// Planes beside recognised surfaces, as polygons.

#include <cstdint>
#include <span>
#include <vector>

#include "base/key_table.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Connected faces in one plane.
struct PlaneRegion {
  Point3 at{0, 0, 0}, normal{0, 0, 1};            ///< a point of the plane, and its unit normal
  std::vector<std::vector<std::uint32_t>> loops;  ///< its outer border first, then its holes; wound as the faces
};

/// The key of an edge in a KeyTable.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a < b ? a : b} << 32 | (a < b ? b : a);
}

struct PlaneRegions {
  std::vector<PlaneRegion> list;
  std::vector<std::uint32_t> region_of;  ///< per face: index into `list`, or kNone
};

/// Finds the regions that border on a recognised surface at one of the edges `borders`. Faces of one region join across
/// edges of two faces of one material that are no lines (`lines`: per edge, 0 if it is none). Regions whose border touches
/// itself are left out.
PlaneRegions plane_regions(const Scene& scene, const Topology& topology, const Patches& patches,
                           const std::vector<std::uint8_t>& lines, std::span<const std::uint32_t> borders);

}  // namespace ligne
