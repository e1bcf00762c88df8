#pragma once
/// The nearest of a set of segments in space.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// A point of a segment near to another point.
struct NearestPoint {
  std::uint32_t segment = kNone;  ///< index, or kNone when none is near enough
  double at = 0;                  ///< 0 at its start, 1 at its end
  double distance = 0;
};

/// A tree of boxes over segments, halved at the median of their middles along the longest side: O(n log n) to build.
class EdgeTree {
 public:
  struct Segment {
    Point3 a, b;
  };
  /// Adjustable: segments that one search looks at.
  static constexpr std::size_t kMostVisits = 256;

  explicit EdgeTree(std::vector<Segment> segments);

  /// The nearest point within `distance` on a segment that `accept(segment, at)` takes. Of equally near ones the first met,
  /// which depends on the segments alone. Looks at `kMostVisits` segments at the most, the nearer boxes first, so that
  /// crowds of segments at one place take no time without bound; beyond that the nearest so far is returned.
  NearestPoint nearest(const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept) const;

  /// The nearest point within `distance` on segments [begin, end), which are all looked at; of equally near ones the first,
  /// and `several` says that there are others.
  NearestPoint nearest_of(std::uint32_t begin, std::uint32_t end, const Point3& p, double distance, bool& several) const;

 private:
  struct Box {
    Point3 low, high;
    double square_distance(const Point3& p) const {
      double square = 0;
      for (int k = 0; k < 3; ++k) {
        const double away = std::max(std::max(low[k] - p[k], p[k] - high[k]), 0.0);
        square += away * away;
      }
      return square;
    }
  };
  /// The middle of a segment along the side that is halved.
  struct Middle {
    double at;
    std::uint32_t segment;
  };
  void build(std::size_t node, std::uint32_t begin, std::uint32_t end, std::vector<Middle>& middles);

  std::vector<Segment> segments_;
  std::vector<std::uint32_t> order_;  ///< of the segments, so that a node is a range
  std::vector<Box> boxes_;            ///< children of node i: 2 i + 1 and 2 i + 2
};

/// The nearest point within `distance` on those of the segments that are listed, which are all looked at, and that `accept`
/// takes; of equally near ones the first that is listed.
NearestPoint nearest_among(std::span<const EdgeTree::Segment> segments, std::span<const std::uint32_t> listed,
                           const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept);

}  // namespace ligne
