#pragma once
/// The study as Atherton and Weiler made it: polygons, nearest first; the one in front clips all others, which fall apart
/// into what is inside and what is outside of it.

#include <functional>

#include "visibility/polygons/visible_faces.hpp"

namespace ligne::atherton_weiler {

struct PolygonCounts {
  std::uint64_t zones = 0;        ///< sets of polygons that hang together by their boxes on the page
  std::uint64_t slabs = 0;        ///< sets of the polygons of a zone that overlap no other in depth
  std::uint64_t bodies = 0;       ///< convex objects, clipped by their silhouettes
  std::uint64_t considered = 0;   ///< polygons of a list before which a clip face stood, apart or not
  std::uint64_t clips = 0;        ///< a polygon clipped by another one
  std::uint64_t wrong_sorts = 0;  ///< pieces found inside that proved to be nearer
  std::uint64_t splits = 0;       ///< pieces cut along the line in which two polygons pass through each other
  std::uint64_t deepest = 0;      ///< recursion
  void operator+=(const PolygonCounts& o);
};

/// Finds the regions of find_visible_faces() by another way; where more than two faces coincide within their tolerances
/// these may give the place to different ones. Time: the square of the number of faces of a zone. `silhouettes`: see
/// clip_units().
VisibleFaces study_polygons(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes,
                            const std::function<void(double)>& progress, PolygonCounts& counts);

}  // namespace ligne::atherton_weiler
