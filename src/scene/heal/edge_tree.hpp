#pragma once
/// Finds the nearest of a set of segments in space.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// A point of a segment near a given point.
struct NearestPoint {
  std::uint32_t segment = kNone;  ///< index, or kNone if none is near enough
  double at = 0;                  ///< parameter: 0 at the start, 1 at the end
  double distance = 0;
};

/// A tree of bounding boxes over segments, halved at the median of their midpoints along the longest side: O(n log n)
/// to build.
class EdgeTree {
 public:
  struct Segment {
    Point3 a, b;
  };
  /// Largest number of segments tested by one search. Adjustable.
  static constexpr std::size_t kMostVisits = 256;

  explicit EdgeTree(std::vector<Segment> segments);

  /// The nearest point within `distance` on a segment for which `accept(segment, at)` is true. Of equally near ones it
  /// returns the first met, which depends on the segments alone. It tests at most `kMostVisits` segments, nearer boxes
  /// first, so that many segments at one place take bounded time; beyond that it returns the nearest one so far.
  NearestPoint nearest(const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept) const;

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
  /// Midpoint of a segment along the side that is halved.
  struct Middle {
    double at;
    std::uint32_t segment;
  };
  void build(std::size_t node, std::uint32_t begin, std::uint32_t end, std::vector<Middle>& middles);

  std::vector<Segment> segments_;
  std::vector<std::uint32_t> order_;  ///< permutation of the segments in which each node is a range
  std::vector<Box> boxes_;            ///< children of node i: 2 i + 1 and 2 i + 2
};

/// The nearest point within `distance` on the listed segments for which `accept` is true, testing all of them. Of
/// equally near ones it returns the first listed.
NearestPoint nearest_among(std::span<const EdgeTree::Segment> segments, std::span<const std::uint32_t> listed,
                           const Point3& p, double distance, FunctionRef<bool(std::uint32_t, double)> accept);

}  // namespace ligne
