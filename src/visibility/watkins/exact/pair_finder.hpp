#pragma once
/// Pairs of facets that may penetrate, found where the scan first meets both.
///
/// Two facets that overlap on the page begin to do so, in the order of the scan, at a point of one of them or where two of
/// their sides cross. There and only there they are compared with each other.

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
  /// Pairs behind `covers`, which may be null, are not wanted.
  PairFinder(const std::vector<Facet>& facets, PenetrationSearch& search, const OccluderGrid* covers, ScanEffort& effort)
      : facets_(facets), search_(search), occluders_(covers), effort_(effort) {}

  /// At a point: the facets that have a corner or a side there against all over a gap below it.
  void at_point(std::span<const std::uint32_t> touched, const Cover& cover);
  /// At a crossing: below it, between the edges, lie the facets left of the left edge and those right of the right one.
  /// `outside` is over the gap left of both.
  void at_crossing(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right, const Cover& outside);

 private:
  static constexpr std::uint64_t kLooksPerTest = 32;  ///< adjustable

  void test(std::uint32_t f, std::uint32_t g);

  const std::vector<Facet>& facets_;
  PenetrationSearch& search_;
  const OccluderGrid* occluders_;
  ScanEffort& effort_;
};

}  // namespace ligne::watkins
