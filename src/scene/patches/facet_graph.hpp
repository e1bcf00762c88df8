#pragma once
/// The flat facets of an object, and the edges between them across which a surface may be smooth.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/index_lists.hpp"
#include "base/uninitialized_vector.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// Largest angle between the normals of adjacent facets of one surface, in degrees. It admits a cylinder of twelve
/// facets (30 degrees), or of eight (45 degrees) if the file says that the surface is smooth. With fewer facets the
/// body counts as a prism (docs/patches.md).
inline constexpr double kLargestBend = 31, kLargestSmoothBend = 46;

/// Largest angle, in degrees, between a patch and a facet beside it whose corners lie on its surface exactly. At the ends of
/// fillets the last triangles are turned far from the surface, and facets of a torus of 12 by 12 bend by up to 31.1 degrees.
inline constexpr double kSteepBend = 60;

/// Adjacent faces whose normals differ by less than this, in degrees, lie in one plane, whatever Object::precision is:
/// coordinates may have been printed with six digits by one program and stored as float32 by another. A cylinder would
/// need more than seven thousand facets to have angles as small.
inline constexpr double kFlatBend = 0.05;

/// The graph of the facets of one object. A facet is a connected set of coplanar faces. An arc joins two adjacent
/// facets: an edge of exactly two faces with consistent windings and an angle of at most kLargestBend, unless the file
/// marks the edge as sharp.
struct FacetGraph {
  struct Arc {
    std::uint32_t facet, edge;  ///< the neighbour, and the edge of the topology
  };

  std::vector<std::uint32_t> facet_of;  ///< per face of the object, in their order: the index of its facet
  /// Per facet: its faces and, each once, its vertices in the scene, of a cut strip those on its rulings alone.
  IndexLists faces, vertices;
  bool has_small_faces = false;            ///< some facets may have faces that rounding has turned (FlatSets)
  UninitializedVector<FacetFrame> frames;  ///< per facet
  UninitializedVector<double> area;        ///< per facet, square model units
  std::vector<std::uint8_t> is_plane;      ///< per facet: 1 if it has too many corners to be part of a curved surface
  /// Per facet: 1 if it has arcs only at edges on two parallel lines, and more corners between these, as CSG leaves where it
  /// cuts the ends of strips: the corners on the lines lie on the surface, those between them on chords.
  std::vector<std::uint8_t> is_cut;
  std::vector<std::uint8_t> is_sliver;   ///< per facet: 1 if it is so narrow that rounding determines its normal
  std::vector<std::uint32_t> arc_begin;  ///< per facet: its first arc
  UninitializedVector<Arc> arcs;
  /// Pairs of adjacent facets that would have an arc but for an angle of up to kSteepBend.
  std::vector<std::array<std::uint32_t, 2>> steep;

  std::size_t size() const { return is_plane.size(); }
  /// Whether a facet without a surface is a plane by the number of its corners.
  bool has_many_corners(std::uint32_t facet) const { return is_plane[facet] || is_cut[facet]; }
  std::span<const Arc> arcs_of(std::uint32_t facet) const {
    return {arcs.data() + arc_begin[facet], arcs.data() + arc_begin[facet + 1]};
  }
};

/// The edges inside facets whose faces bend by more than those that are joined by themselves: rounding turns small faces
/// of a plane. Ascending.
std::vector<std::uint32_t> edges_inside_planes(const Topology& topology, const Object& object, const FacetGraph& graph,
                                               std::uint32_t edge_begin, std::uint32_t edge_end,
                                               std::span<const glm::vec3> normals);

/// The graph of one object with these edges in the topology. `normals` are those of face_normals(), and `joints` the edges
/// of flat_joints(), which are found if they are not given.
FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                       std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints);
FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                       std::span<const glm::vec3> normals);

}  // namespace ligne
