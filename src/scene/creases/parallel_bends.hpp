#pragma once
/// Edges that bend, by their ends, and those inside fillets.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// One end of an edge that bends.
struct BendEnd {
  std::uint32_t vertex, edge;
  friend bool operator<(const BendEnd& a, const BendEnd& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.edge < b.edge;
  }
};

/// Whether an edge lies inside a row of parallel edges, two or more on either side, that bend to the same side: the facets
/// of a fillet, along which no line runs.
bool is_inside_fillet(const EdgeRows& rows, std::uint32_t edge);

/// Whether an edge is no part of a fillet: inside one, the edges beside it bend alike on both sides, at similar distances.
/// The rims of a bevel have each other on one side and a plane on the other.
bool stands_out(const EdgeRows& rows, std::uint32_t edge, const RowBends& bends = kRoundingBends);

/// Whether a way over edges stands out from even rows along half of its length or more. Otherwise it is one of many along a
/// fillet. Edges count half that a cut may have made the last ones of their rows.
bool is_line(const Scene& scene, const Topology& topology, const EdgeRows& rows, std::span<const std::uint32_t> way);

/// The edges that bend.
struct BendEnds {
  std::span<const BendEnd> list;           ///< sorted
  std::span<const PatchEdge> patch_edges;  ///< per edge of the topology
  const EdgeRows& rows;
};

/// Makes weak bends of strong ones inside fillets of which the recognised surfaces say nothing, as they are no lines:
/// those that exceed the crease angle by no more than what a coarse mesh of a bent tube does, and whole lines that meet no
/// other one.
void soften_fillets(const Scene& scene, const Topology& topology, const BendEnds& ends, double crease_degrees,
                    std::vector<Bend>& bends);

}  // namespace ligne
