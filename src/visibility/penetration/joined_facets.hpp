#pragma once
/// Squares of the page in which a surface lies in one layer, so that no facets penetrate each other.
///
/// A facet is joined if each of its three sides has one facet on the other side, whose face is wound alike. In a square of
/// which the list holds joined facets alone, and with each of them its neighbours across the sides that pass through the
/// square, the sides cancel each other in pairs. So all points of the square lie in equally many facets: if its centre lies
/// in one, no two of them overlap.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/topology.hpp"
#include "visibility/common/cell_grid.hpp"

namespace ligne {

/// Per facet: 1 or 2 if it is joined, according to the sense in which the corners of its face turn on the page; else 0.
/// Empty unless all faces are triangles that lie on the page as a whole, and no edge has more than two of them. `facets`:
/// those of make_facets().
std::vector<std::uint8_t> joined_facets(const ProjectedScene& scene, const Topology& topology,
                                        const std::vector<Facet>& facets);

/// A leaf of the grid with its list.
struct ListedLeaf {
  const Cell& cell;
  std::span<const CellFacet> list;  ///< not empty
  const CellSquare& square;
  double margin;  ///< of the grid
};

/// Whether the facets of a leaf certainly form one layer, or two layers that turn in two senses, one behind the other.
/// `joined`: joined_facets(), not empty.
bool has_layers_apart(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const std::uint8_t> joined,
                      const ListedLeaf& leaf);

}  // namespace ligne
