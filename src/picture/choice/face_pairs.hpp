#pragma once
/// Pairs of faces that overlap or penetrate each other.

#include <cstdint>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// Each pair is lower face << 32 | higher face. The lists are sorted and free of duplicates.
struct FacePairs {
  std::vector<std::uint64_t> overlapping;  ///< pairs with a common part of the page
  std::vector<std::uint64_t> penetrating;  ///< pairs that pass through each other
  bool complete = true;                    ///< false if there were too many pairs to test all
};

/// A grid over the page whose lists hold all facets, the hidden ones too.
CellGrid grid_of_all(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps);

/// Finds the pairs among the facets of the scene, cell by cell of grid_of_all(). Tests a few million pairs of facets at
/// most.
FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid);

}  // namespace ligne
