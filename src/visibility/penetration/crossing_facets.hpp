#pragma once
/// All pairs of facets that may pass through each other, the hidden ones too.
///
/// A tree of the facets (facet_tree.hpp) is held against itself: pairs of nodes whose boxes or slabs are apart end there,
/// and those whose facets are all of one face.

#include <vector>

#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// O(n log n) and the pairs that are near each other.
PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets);

}  // namespace ligne
