#pragma once
/// Tests whether units may overlap on the page, and the zones that follow from them: [Boulle1980] 2.4.2.1 and 2.4.3.2.

#include <vector>

#include "visibility/atherton_weiler/clip_units.hpp"
#include "visibility/atherton_weiler/polygon_options.hpp"

namespace ligne::atherton_weiler {

/// Bounding rectangles of a unit on the page: along the axes, and along the diagonals in the coordinates x + y and x - y.
struct PageExtent {
  PageBox upright, diagonal;

  void extend(const PageExtent& o) {
    upright.extend(o.upright);
    diagonal.extend(o.diagonal);
  }
};

/// Tests pairs of units by one of the tests.
class OverlapTests {
 public:
  OverlapTests(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
               ZoneTest test);

  ZoneTest test() const { return test_; }
  const PageExtent& extent(std::uint32_t unit) const { return extents_[unit]; }

  /// Whether polygons of the two units may overlap by the tests that serve within a zone. False only if the units have no
  /// inner points in common.
  bool may_overlap(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const;

  /// Whether the units may overlap by the tests that divide into zones. Exact for contours.
  bool are_connected(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const;

 private:
  bool hulls_overlap(std::uint32_t a, std::uint32_t b, PolygonCounts& counts) const;

  const std::vector<ClipUnit>& units_;
  ZoneTest test_;
  std::vector<PageExtent> extents_;
  std::vector<std::vector<LatticePoint>> hulls_;  ///< per unit: the corners of its convex hull; empty if not tested
};

/// Sets of units that are connected by overlaps, sorted by their lowest unit. With boxes: O(n log n). With the other tests
/// O((n + k) log n), where k pairs of units have overlapping boxes but prove apart; units at one place, however many, take
/// O(n log n) as well.
std::vector<std::vector<std::uint32_t>> zones_of(const std::vector<ClipUnit>& units, const OverlapTests& tests,
                                                 PolygonCounts& counts);

}  // namespace ligne::atherton_weiler
