#pragma once
/// Finds the segments in which facets penetrate each other. There are none where the scene states so.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// Finds all segments of penetrating facets that are not wholly behind the covers of their cells, or all segments if
/// the grid is complete; see PenetrationSearch::finish. `joined`: joined_facets(), or empty.
std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps,
                                             std::span<const std::uint8_t> joined = {});

/// Makes a grid for the search, or finds all segments if `hidden_too`.
std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             double coincidence_steps, bool hidden_too);

}  // namespace ligne
