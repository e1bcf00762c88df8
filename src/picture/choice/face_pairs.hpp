#pragma once
/// Pairs of faces that overlap or penetrate each other.

#include <cstdint>
#include <vector>

#include "visibility/common/facet.hpp"

namespace ligne {

/// Each pair is lower face << 32 | higher face. The lists are sorted and free of duplicates.
struct FacePairs {
  std::vector<std::uint64_t> overlapping;  ///< pairs with a common part of the page
  std::vector<std::uint64_t> penetrating;  ///< pairs that pass through each other
  bool complete = true;                    ///< false if there were too many pairs to test all
};

/// Finds the pairs among the facets of the scene, cell by cell of a grid over the page. Tests a few million pairs of
/// facets at most.
FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps);

}  // namespace ligne
