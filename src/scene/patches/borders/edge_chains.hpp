#pragma once
/// Chains of edges along the border of a surface.

#include <cstdint>
#include <span>

#include "base/disjoint_sets.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Adjustable. Least cosine between consecutive edges of one line along a border: 45 degrees. Behind a sharper turn another
/// line begins.
inline constexpr double kChainCosine = 0.70710678;

/// An edge on the border of something: a patch, or the faces beyond a free form.
struct BorderEdge {
  std::uint32_t edge, owner;
};

/// Joins border edges of one owner that continue each other, by at most 45 degrees, at a vertex where exactly two of its
/// border edges end. The members of the sets are numbers of border edges. O(n log n).
DisjointSets edge_chains(const Scene& scene, const Topology& topology, std::span<const BorderEdge> borders);

}  // namespace ligne
