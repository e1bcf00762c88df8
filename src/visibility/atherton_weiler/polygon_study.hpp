#pragma once
/// The study by Atherton and Weiler: polygons sorted by nearest depth. The front polygon clips all others into the parts
/// inside and outside it.

#include <functional>

#include "visibility/polygons/visible_faces.hpp"

namespace ligne::atherton_weiler {

struct PolygonCounts {
  std::uint64_t zones = 0;        ///< sets of polygons connected by overlapping boxes on the page
  std::uint64_t slabs = 0;        ///< subsets of a zone with disjoint depth ranges
  std::uint64_t bodies = 0;       ///< convex objects clipped by their silhouettes
  std::uint64_t considered = 0;   ///< polygons in a list behind a clip face, overlapping it or not
  std::uint64_t clips = 0;        ///< clips of one polygon by another
  std::uint64_t wrong_sorts = 0;  ///< pieces inside a clip face that proved nearer
  std::uint64_t splits = 0;       ///< pieces cut along the intersection line of two penetrating polygons
  std::uint64_t deepest = 0;      ///< deepest recursion
  void operator+=(const PolygonCounts& o);
};

/// Finds the regions of find_visible_faces() by another algorithm. Where more than two faces coincide within their
/// tolerances, the two may choose different faces. Time: quadratic in the number of faces of a zone. `silhouettes`: see
/// clip_units().
VisibleFaces study_polygons(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes,
                            const std::function<void(double)>& progress, PolygonCounts& counts);

}  // namespace ligne::atherton_weiler
