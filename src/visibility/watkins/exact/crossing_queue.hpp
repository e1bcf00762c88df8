#pragma once
/// The future crossings of the exact scan, in scan order; pairs of facets that may penetrate.

#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "visibility/penetration/penetration.hpp"
#include "visibility/watkins/exact/occluder_grid.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"

namespace ligne::watkins {

struct Crossing {
  double y, x;
  std::uint32_t left, right;  ///< nodes of the active list
  std::uint32_t left_generation, right_generation;

  bool before(double other_y, double other_x) const { return y != other_y ? y < other_y : x < other_x; }
};

/// May hold crossings that other events have made invalid.
class CrossingQueue {
 public:
  void put(const Crossing& crossing) { heap_.push(crossing); }
  /// Removes and returns the next crossing before the place.
  std::optional<Crossing> take_before(double y, double x);

 private:
  /// Ties are broken by the nodes, so only copies compare equal.
  struct Later {
    bool operator()(const Crossing& a, const Crossing& b) const {
      if (a.y != b.y) return a.y > b.y;
      if (a.x != b.x) return a.x > b.x;
      if (a.left != b.left) return a.left > b.left;
      return a.right > b.right;
    }
  };

  std::priority_queue<Crossing, std::vector<Crossing>, Later> heap_;
};

/// Finds pairs of facets that may penetrate, where the scan first meets both.
///
/// In scan order, the overlap of two facets on the page begins at a corner of one of them or at a crossing of two of their
/// sides. They are compared only there.
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
