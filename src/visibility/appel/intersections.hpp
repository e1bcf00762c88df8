#pragma once
/// The segments in which facets penetrate each other.

#include <vector>

#include "visibility/appel/cell_grid.hpp"

namespace ligne::appel {

/// Common segment of two facets that pass through each other.
struct Intersection {
  ProjectedVertex from, to;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< faces of the scene, face0 <= face1
};

/// All segments of penetrating facets that are not wholly behind the covers of the cells they run through, each once,
/// ordered by facets. Facets that only touch, within their tolerance, give none: neither do neighbours with a common side.
/// Where a side of one facet lies in the plane of another there is a segment only if the surface goes on on the other side.
std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps);

}  // namespace ligne::appel
