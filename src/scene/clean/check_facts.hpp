#pragma once
/// Checks stated facts where that is cheap.

#include <string>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Returns a phrase that names the object for which a stated fact is false, or an empty text.
///
/// Separating planes: all vertices, exactly. Convex bodies: that every edge has two faces and bends outwards, that the
/// object is one part, that it has one highest place in six directions, and 16 faces against all its vertices; O(n).
/// Penetrations: all pairs of triangles of a scene of up to 1,024 triangles; of a larger one as many triangles as make about
/// a million pairs, against all. Adjacency: all edges.
std::string find_false_fact(const Scene& scene, const Topology& topology);

/// Checks one fact, whether it is stated or not. Returns a phrase that says for which object it is false, or an empty text.
std::string why_false(const Scene& scene, const Topology& topology, StatedFact fact);

/// Whether the check of penetrations tests all pairs of triangles.
bool tests_all_pairs(const Topology& topology);

}  // namespace ligne
