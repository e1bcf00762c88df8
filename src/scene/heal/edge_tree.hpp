#pragma once
/// Finds the nearest of a set of segments in space.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/hash.hpp"
#include "base/index_lists.hpp"
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

/// If most segments near a point are its own and their neighbours, reading one cell costs less than descending a tree.
/// Cells are about as wide as two segments are long, and are kept in a hash table. O(n).
class SegmentCells {
 public:
  /// Prepares for queries of segments within `reach`.
  SegmentCells(std::span<const EdgeTree::Segment> segments, double reach);

  /// All segments within reach of a point in the segments' bounding box. May list others too, and repeat some.
  std::span<const std::uint32_t> near(const Point3& p) const {
    const std::size_t slot = slot_of(cell_of(p));
    return listed_[slot];
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cell_of(const Point3& p) const {
    const Point3 q = (p - low_) / side_;
    return {static_cast<std::int64_t>(q.x), static_cast<std::int64_t>(q.y), static_cast<std::int64_t>(q.z)};
  }
  std::size_t slot_of(const Cell& cell) const {
    return extend_hash(0, static_cast<std::uint64_t>(cell.x << 42 ^ cell.y << 21 ^ cell.z)) & (slots_ - 1);
  }
  void choose_cells(std::span<const EdgeTree::Segment> segments, double reach);

  Point3 low_{0, 0, 0};
  double side_ = 1, margin_ = 0;
  std::size_t slots_ = 1;  ///< a power of two
  IndexLists listed_;      ///< segments per slot
};

}  // namespace ligne
