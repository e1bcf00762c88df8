#pragma once
/// The segments in which facets penetrate each other.

#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// All segments of penetrating facets that are not wholly behind the covers of the cells they run through, or all of them
/// where the grid is complete; see PenetrationSearch::finish.
std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps);

/// Makes the grid as well. Finds all segments where hidden lines are wanted too.
std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             double coincidence_steps, bool hidden_too);

}  // namespace ligne
