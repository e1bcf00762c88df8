#pragma once
/// The faces that are in front somewhere, found at sample points.

#include <cstdint>
#include <vector>

#include "visibility/common/cell_grid.hpp"

namespace ligne {

struct FacesInFront {
  std::vector<std::uint8_t> flags;  ///< per face of the scene: 1 if it was found in front
  bool complete = true;             ///< false if there were too many facets at the sample points to test all
};

/// Tests the points of a regular grid of 512 rows over the facets, and the middle of each facet. A face is in front at a
/// point inside one of its facets if no opaque facet there is nearer by more than the depth tolerance. So a face is missed
/// only where the grid misses all of its visible part, and something hides the middles of its facets. `grid` holds the
/// hidden facets too. Tests a bounded number of facets for each of them, on the average.
FacesInFront find_faces_in_front(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                 const Rect& around);

}  // namespace ligne
