#pragma once
/// Finds pairs of facets that may penetrate, where the scan first meets both.
///
/// In scan order, the overlap of two facets on the page begins at a corner of one of them or at a crossing of two of their
/// sides. They are compared only there.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/penetration/penetration.hpp"
#include "visibility/watkins/exact/occluder_grid.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"
#include "visibility/watkins/scan_effort.hpp"

namespace ligne::watkins {

class PairFinder {
 public:
  /// Skips pairs behind `covers`, which may be null.
  PairFinder(const std::vector<Facet>& facets, PenetrationSearch& search, const OccluderGrid* covers, ScanEffort& effort)
      : facets_(facets), search_(search), occluders_(covers), effort_(effort) {}

  /// At a point: tests the facets with a corner or side there against all facets over a gap below it.
  void at_point(std::span<const std::uint32_t> touched, const Cover& cover);
  /// At a crossing: below it, between the edges, lie the facets left of the left edge and the facets right of the right
  /// edge. `outside` is the cover of the gap left of both.
  void at_crossing(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right, const Cover& outside);

 private:
  static constexpr std::uint64_t kLooksPerTest = 32;  ///< effort of one test, see ScanEffort. Tuned

  void test(std::uint32_t f, std::uint32_t g);

  const std::vector<Facet>& facets_;
  PenetrationSearch& search_;
  const OccluderGrid* occluders_;
  ScanEffort& effort_;
};

}  // namespace ligne::watkins
