#pragma once
/// Finds all pairs of facets that may penetrate each other, hidden ones included.
///
/// Compares a tree of the facets (facet_tree.hpp) with itself. A pair of nodes is dropped if their boxes or slabs are
/// apart, or if all their facets are of one face.

#include <vector>

#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// O(n log n) plus the number of pairs that are near each other.
PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets);

}  // namespace ligne
