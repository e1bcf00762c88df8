#pragma once
/// The study by Atherton and Weiler: polygons sorted by nearest depth. The front polygon clips all others into the parts
/// inside and outside it.

#include <functional>

#include "visibility/atherton_weiler/polygon_options.hpp"
#include "visibility/polygons/visible_faces.hpp"

namespace ligne::atherton_weiler {

/// Finds the regions of find_visible_faces() by another algorithm. Where more than two faces coincide within their
/// tolerances, the two may choose different faces. Time: quadratic in the number of faces of a zone. All
/// options give the same regions.
VisibleFaces study_polygons(const ProjectedScene& scene, const std::vector<Facet>& facets, const PolygonOptions& options,
                            const std::function<void(double)>& progress, PolygonCounts& counts);

}  // namespace ligne::atherton_weiler
