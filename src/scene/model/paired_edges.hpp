#pragma once
/// Edges of scenes whose adjacency is stated.

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Finds the edges of a scene if each side of a face is, in the opposite direction, a side of exactly one other face;
/// returns false otherwise, or if corners have flags, and leaves `topology` as it is. Sorts one half-edge of each edge, and
/// finds the edge of the other half-edge by its lower vertex. The edges are those of build_topology(). O(corners).
bool find_paired_edges(const Scene& scene, Topology& topology);

/// Whether every edge has two faces that run along it in opposite directions. O(edges).
bool is_paired(const Topology& topology);

}  // namespace ligne
