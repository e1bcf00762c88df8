#pragma once
/// Choices and counts of the classical study.

#include <algorithm>
#include <cstdint>

#include "base/add_counts.hpp"

namespace ligne::atherton_weiler {

/// The clip of two faces.
enum class ClipKind : std::uint8_t {
  general,  ///< contours of any form, edge by edge
  convex    ///< convex contours by codes of their corners, others as in `general`
};

/// The test that decides whether two faces may overlap on the page, [Boulle1980] 2.4.3.2. It divides the scene into zones,
/// and spares clips within a zone. Each one includes the tests before it.
enum class ZoneTest : std::uint8_t {
  boxes,     ///< bounding rectangles along the axes
  octagons,  ///< also bounding rectangles along the diagonals
  hulls,     ///< convex hulls
  contours   ///< between zones the contours themselves, within a zone hulls
};

/// The time at which a face found inside a clip face, and nearer, becomes the clip face, [Boulle1980] 2.4.2.4.
enum class InsideTest : std::uint8_t {
  after,   ///< after the clip face has clipped its whole list
  at_once  ///< as soon as it is found
};

struct PolygonOptions {
  bool silhouettes = false;  ///< see clip_units()
  ClipKind clip = ClipKind::convex;
  ZoneTest zones = ZoneTest::boxes;
  InsideTest inside = InsideTest::after;
};

struct PolygonCounts {
  std::uint64_t zones = 0;           ///< sets of polygons connected by overlaps on the page
  std::uint64_t slabs = 0;           ///< subsets of a zone with disjoint depth ranges
  std::uint64_t bodies = 0;          ///< convex objects clipped by their silhouettes
  std::uint64_t considered = 0;      ///< polygons in a list behind a clip face, overlapping it or not
  std::uint64_t clips = 0;           ///< clips of one polygon by another
  std::uint64_t empty_clips = 0;     ///< clips that found nothing inside
  std::uint64_t wrong_sorts = 0;     ///< pieces inside a clip face that proved nearer
  std::uint64_t splits = 0;          ///< pieces cut along the intersection line of two penetrating polygons
  std::uint64_t deepest = 0;         ///< deepest recursion
  std::uint64_t exchanges = 0;       ///< clip faces given up at once for a nearer polygon
  std::uint64_t zone_tests = 0;      ///< pairs whose boxes overlap, tested by more than boxes to find zones
  std::uint64_t pair_tests = 0;      ///< pairs of a list whose boxes overlap, tested by more than boxes before a clip
  std::uint64_t told_apart = 0;      ///< of these, pairs that proved apart
  std::uint64_t test_signs = 0;      ///< signs of corners against lines in tests of pairs
  std::uint64_t convex_pairs = 0;    ///< pairs of convex contours clipped by codes
  std::uint64_t convex_apart = 0;    ///< of these, pairs without common inner points
  std::uint64_t convex_within = 0;   ///< of these, pairs with the subject inside the clip contour
  std::uint64_t parts_outside = 0;   ///< of these pairs, parts of the subject outside
  std::uint64_t convex_outside = 0;  ///< of these parts, convex ones
  std::uint64_t general_clips = 0;   ///< clips of contours of any form
  std::uint64_t signs = 0;           ///< signs of corners against lines in clips
  void operator+=(const PolygonCounts& o) {
    const std::uint64_t most = std::max(deepest, o.deepest);
    add_counts(*this, o);
    deepest = most;
  }
};

}  // namespace ligne::atherton_weiler
