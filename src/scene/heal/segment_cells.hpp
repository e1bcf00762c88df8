#pragma once
/// Lists segments by the cells of space near them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/hash.hpp"
#include "geometry/point.hpp"
#include "scene/heal/edge_tree.hpp"

namespace ligne {

/// If most segments near a point are its own and their neighbours, reading one cell costs less than descending a tree.
/// Cells are about as wide as two segments are long, and are kept in a hash table. O(n).
class SegmentCells {
 public:
  /// Prepares for queries of segments within `reach`.
  SegmentCells(std::span<const EdgeTree::Segment> segments, double reach);

  /// All segments within reach of a point in the segments' bounding box. May list others too, and repeat some.
  std::span<const std::uint32_t> near(const Point3& p) const {
    const std::size_t slot = slot_of(cell_of(p));
    return {listed_.data() + begin_[slot], listed_.data() + begin_[slot + 1]};
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
    return extend_hash(0, static_cast<std::uint64_t>(cell.x << 42 ^ cell.y << 21 ^ cell.z)) & (begin_.size() - 2);
  }
  void choose_cells(std::span<const EdgeTree::Segment> segments, double reach);

  Point3 low_{0, 0, 0};
  double side_ = 1, margin_ = 0;
  std::vector<std::uint32_t> begin_;   ///< per slot (their number is a power of two): the first segment; and the end
  std::vector<std::uint32_t> listed_;  ///< segments
};

}  // namespace ligne
