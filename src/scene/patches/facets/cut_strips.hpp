#pragma once
/// Strips of curved surfaces that other bodies cut at their ends.

#include <cstddef>

#include "scene/patches/facet_graph.hpp"

namespace ligne {

/// Largest number of corners of a facet that is curved wherever they lie.
inline constexpr std::size_t kStripCorners = 4;

/// Largest number of corners of a facet whose corners lie on two rulings.
inline constexpr std::size_t kMostRulingCorners = 16;

/// Makes strips of the facets of a graph that are cut strips (FacetGraph::is_cut): sets FacetGraph::is_plane, is_cut and
/// vertices. The graph has its arcs already.
void find_cut_strips(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph);

}  // namespace ligne
