#pragma once
/// Vertices of recognised surfaces that lie on chords, and their places on the surfaces.
///
/// CSG cuts facets, so the vertices along a cut lie on the chords of the surfaces that meet there. Edges between such
/// vertices zigzag about the common line of the surfaces, and would do so at any number of new vertices.

#include <cstdint>
#include <vector>

#include "scene/patches/refine/plane_regions.hpp"

namespace ligne {

/// Least distance of a vertex on a chord from its surface, in sags of the patch: corners of approximated fillets lie nearer.
inline constexpr double kOffSags = 0.3;

/// Vertices that lie beside refined surfaces.
struct ChordCorners {
  std::vector<std::uint32_t> moved;    ///< vertices that have places on all surfaces around them; ascending
  std::vector<Point3> places;          ///< per moved vertex
  std::vector<std::uint32_t> regions;  ///< plane regions with a moved vertex on their border; may repeat
  std::vector<std::uint32_t> patches;  ///< patches with a vertex beside their surface that has no such place; may repeat
};

/// Finds the vertices of patches with a level above 0 that lie beside their surface. Vertices move only if all faces around
/// them belong to such patches or to plane regions, three of these at most.
ChordCorners chord_corners(const Scene& scene, const Topology& topology, const Patches& patches, const PlaneRegions& planes,
                           const std::vector<std::uint8_t>& levels);

}  // namespace ligne
