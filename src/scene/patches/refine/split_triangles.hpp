#pragma once
/// Splits the triangles of recognised surfaces until their edges lie near the surfaces.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/key_table.hpp"
#include "scene/patches/refine/plane_regions.hpp"

namespace ligne {

/// How near to the surfaces the edges of a mesh have to lie.
struct RefineLimits {
  double most_mm = 0;                            ///< largest distance of the middle of an edge from its surface, on the page
  std::function<double(const Point3&)> unit_mm;  ///< size of a model unit on the page at a point; 0: it is not seen
};

/// A triangle of a face of the given scene.
struct FacePart {
  std::array<std::uint32_t, 3> v{};
  std::uint32_t face = 0;
  bool is_turned = false;  ///< it has an edge that is none of the given ones, between given vertices
};

/// The triangles of refined faces. Edges are split at new vertices, which are numbered after those of the scene.
struct SplitTriangles {
  std::vector<FacePart> parts;                ///< of all faces with a surface that is refined, sorted by face
  std::vector<Point3> points;                 ///< the new vertices
  std::vector<Point3> placed;                 ///< the places of the given vertices if some have moved, else empty
  std::vector<std::uint32_t> beside;          ///< per new vertex: a vertex of the scene in its object
  KeyTable middles{};                         ///< by the key of an edge: the new vertex that splits it
  std::vector<std::uint8_t> is_region_split;  ///< per plane region: 1 if its border has new or moved vertices

  /// Appends the vertices of the pieces of the edge from a to b, without b.
  void append_pieces(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& to) const;
};

/// How often edges have to be halved.
struct EdgeLevels {
  std::vector<std::uint32_t> curved;     ///< edges whose middle lies beside a recognised surface of either face; ascending
  std::vector<std::uint8_t> of_patch{};  ///< per patch: how often its curved edges are halved; 0: it is not refined
  std::vector<std::uint32_t> set_of{};   ///< per patch: the first one of those that it meets along curved edges
  std::vector<std::uint32_t> rims{};     ///< open edges that may be halved; ascending
};

/// Finds the levels that the limits need: surfaces that meet along curved edges are refined alike, as if the part had more
/// facets to a turn.
EdgeLevels edge_levels(const Scene& scene, const Topology& topology, const Patches& patches, const RefineLimits& limits);

/// Halves the curved edges inside a refined surface, at its rims, between two of them and between a surface and a plane
/// region, and halves the halves. Vertices on chords of the surfaces move onto these (chord_corners.hpp). Connected surfaces
/// are refined only if this is possible along all of their borders: otherwise they would no longer fit together.
SplitTriangles split_triangles(const Scene& scene, const Topology& topology, const Patches& patches,
                               const PlaneRegions& planes, const EdgeLevels& levels);

}  // namespace ligne
