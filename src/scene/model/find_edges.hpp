#pragma once
/// The edges of a scene.

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Finds the edges of a scene with their flags: Topology::edges, edge_flags and first_edges. Sorts only half of the
/// half-edges where adjacency is stated and found to be true. O(corners).
void find_edges(const Scene& scene, Topology& topology);

/// Finds the edges of a scene if each side of a face is, in the opposite direction, a side of exactly one other face;
/// returns false otherwise, or if corners have flags, and leaves `topology` as it is. Sorts one half-edge of each edge, and
/// finds the edge of the other half-edge by its lower vertex. The edges are those of find_edges(). O(corners).
bool find_paired_edges(const Scene& scene, Topology& topology);

/// Whether every edge has two faces that run along it in opposite directions. O(edges).
bool is_paired(const Topology& topology);

}  // namespace ligne
