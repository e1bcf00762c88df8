#pragma once
/// The flat facets of an object and the bends between them over which a surface may run smoothly.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// Lists of indices, one behind the other.
struct IndexLists {
  std::vector<std::uint32_t> begin{0}, values;

  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {values.data() + begin[i], values.data() + begin[i + 1]};
  }
};

/// Largest bend between two facets of one surface, in degrees: twelve facets a turn, and eight where the file says that the
/// surface is smooth. Fewer are a polygon (docs/patches.md).
inline constexpr double kLargestBend = 31, kLargestSmoothBend = 46;

/// Flatter bends, in degrees, are those of one plane whatever the precision is said to be: programs print six digits, and
/// others store these as float32. Seven thousand facets go round in larger ones.
inline constexpr double kFlatBend = 0.05;

/// A facet is a set of faces that hang together in one plane. Neighbours are joined by arcs: edges of two faces that are
/// wound alike and bend by no more than surfaces do (kLargestBend), unless the file calls the edge sharp.
struct FacetGraph {
  struct Arc {
    std::uint32_t facet, edge;  ///< the neighbour, and the edge of the topology
  };

  std::vector<std::uint32_t> facet_of;  ///< per face of the object, counted from its first one
  IndexLists faces, vertices;           ///< per facet, of the scene; each vertex once
  std::vector<FacetFrame> frames;
  std::vector<double> area;
  std::vector<std::uint8_t> is_plane;   ///< 1 where a facet has too many corners to be part of a curved surface
  std::vector<std::uint8_t> is_sliver;  ///< 1 where rounding decides on the normal
  std::vector<std::uint32_t> arc_begin;
  std::vector<Arc> arcs;

  std::size_t size() const { return frames.size(); }
  std::span<const Arc> arcs_of(std::uint32_t facet) const {
    return {arcs.data() + arc_begin[facet], arcs.data() + arc_begin[facet + 1]};
  }
};

/// The graph of one object with its edges [edge_begin, edge_end) of the topology. `normals` are those of face_normals().
FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, std::uint32_t edge_begin,
                       std::uint32_t edge_end, std::span<const glm::vec3> normals);

}  // namespace ligne
