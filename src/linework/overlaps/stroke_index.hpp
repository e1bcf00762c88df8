#pragma once
/// Finds the segments of the page that may coincide with a given segment.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "base/key_table.hpp"
#include "geometry/lattice.hpp"
#include "linework/overlaps/chunk_pool.hpp"
#include "linework/overlaps/span_pool.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Smallest side of a cell, in tolerances. It keeps the reach of the tolerance small against the cell.
inline constexpr double kLeastCellInTolerances = 8;

/// A range of grid cells, ends included; all cells by default.
struct CellRange {
  std::int32_t column0 = std::numeric_limits<std::int32_t>::min(), row0 = column0;
  std::int32_t column1 = std::numeric_limits<std::int32_t>::max(), row1 = column1;
};

/// A uniform grid of square cells over the page.
class SegmentGrid {
 public:
  /// `cell` is the side of a cell, `tolerance` the distance within which a point counts as on a segment, both in
  /// lattice steps.
  SegmentGrid(double cell, double tolerance) : cell_(cell), margin_(tolerance + kRounding) {}

  std::uint64_t cell_of(LatticePoint p) const { return KeyTable::key(index(p.x), index(p.y)); }

  /// Calls visit(cell) for every cell within the tolerance of the segment until it returns true. Returns whether it
  /// did.
  template <class Visit>
  bool walk(LatticePoint from, LatticePoint to, const Visit& visit) const {
    return walk_cells(from, to, {},
                      [&](std::int32_t column, std::int32_t row) { return visit(KeyTable::key(column, row)); });
  }

  /// Calls visit(column, row) for those cells that lie in a range.
  template <class Visit>
  bool walk_cells(LatticePoint from, LatticePoint to, const CellRange& range, const Visit& visit) const;

  /// Whether the point may lie on the infinite line of the segment.
  bool near(LatticePoint p, LatticePoint from, LatticePoint to, double segment_length) const {
    return std::abs(orientation(from, to, p)) <= margin_ * segment_length;
  }
  /// near() for a segment of unknown length.
  bool near(LatticePoint p, LatticePoint from, LatticePoint to) const {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, area = orientation(from, to, p);
    return area * area <= margin_ * margin_ * (dx * dx + dy * dy);
  }
  /// Whether the foot of the point's perpendicular is on the segment or at most the margin beyond its ends.
  bool beside(LatticePoint p, LatticePoint from, LatticePoint to) const {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, squared = dx * dx + dy * dy;
    const double along = dx * (double(p.x) - from.x) + dy * (double(p.y) - from.y),
                 beyond = std::max(-along, along - squared);
    return beyond <= 0 || beyond * beyond <= margin_ * margin_ * squared;
  }

 private:
  static constexpr double kRounding = 2;  ///< lattice steps; more than the rounding error of any position here

  std::int32_t index(double v) const { return static_cast<std::int32_t>(std::floor(v / cell_)); }

  double cell_, margin_;
};

/// A grid over segments, stored as a hash table of its cells. Segments are numbered in the order of insertion. A cell
/// with too many entries passes them to the cells of a finer grid.
///
/// Where two segments coincide, each end of their common interval is an end of one of them and lies on the other. So a
/// query needs only the segments that pass the ends of the new one, and the ends that lie along the new one. A cell
/// therefore keeps two lists: the segments that pass through it without ending in it, and the points in it where
/// segments end, each with its segments. Segments that share one end are found by their other ends; those that share
/// both ends, by a table of pairs of ends. So a point where thousands of segments meet adds no cost to a query. Where a
/// cell has hundreds of segments, few are near the query; the lists hold the coordinates for this test side by side.
class StrokeIndex {
 public:
  /// Side of the cells and tolerance, as for SegmentGrid.
  StrokeIndex(double cell, double tolerance) : tolerance_(tolerance) { levels_.emplace_back(cell, tolerance); }

  void insert(LatticePoint from, LatticePoint to);

  /// Queries no longer find segment number `segment`. It keeps its number.
  void erase(std::uint32_t segment);

  /// Calls found(segment) for every inserted segment that may coincide with from-to, until it returns true. Some
  /// segments come more than once. Returns whether found() did return true.
  template <class Found>
  bool query(LatticePoint from, LatticePoint to, const Found& found) const;

 private:
  struct Segment {
    LatticePoint from, to;
    bool erased = false;
    std::uint32_t ends[2] = {};  ///< indices of its two end points
    std::uint32_t arms[2] = {};  ///< its places in the lists of arms of these points
  };
  /// A segment that passes through a cell without ending in it.
  struct Through {
    LatticePoint from, to;
    std::uint32_t segment;
  };
  struct PlacedEnd {
    LatticePoint p;
    std::uint32_t point;
  };
  /// A segment that ends at a point.
  struct Arm {
    LatticePoint far;
    std::uint32_t segment;
  };
  struct Cell {
    ChunkPool<Through>::List throughs;
    ChunkPool<PlacedEnd>::List ends;
    bool refined = false;  ///< the cells of the next level have its entries
  };
  /// A grid. The cells of the next level have a kParts-th of its side.
  struct Level {
    Level(double cell_side, double tolerance) : side(cell_side), grid(cell_side, tolerance) {}
    double side;
    SegmentGrid grid;
    KeyTable cells;
  };
  struct EndPoint {
    LatticePoint p;
    SpanPool<Arm>::List arms{};
    bool listed = true;  ///< whether the list of its cell contains it
  };

  static std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
  }
  static CellRange parts_of(std::int32_t column, std::int32_t row) {
    return {column * kParts, row * kParts, column * kParts + kParts - 1, row * kParts + kParts - 1};
  }
  std::uint32_t cell(std::size_t level, std::uint64_t key);
  std::uint32_t leaf_at(LatticePoint p) const;
  void add_end(std::uint32_t segment, int side);
  void pass(std::size_t level, const CellRange& range, std::uint32_t segment);
  void put_point(std::size_t level, std::uint32_t point);
  void refine_if_full(std::size_t level, std::uint64_t key, std::uint32_t cell);
  template <class Visit>
  bool visit_leaves(std::size_t level, const CellRange& range, LatticePoint from, LatticePoint to, const Visit& visit) const;
  template <class Found>
  bool visit_passing(const Cell& cell, LatticePoint p, LatticePoint other, const Found& found) const;
  template <class Found>
  bool visit_along(const Cell& cell, LatticePoint from, LatticePoint to, const Found& found) const;

  static constexpr std::int32_t kParts = 2;
  double tolerance_;
  std::vector<Level> levels_;
  KeyTable point_table_, pair_table_;
  std::vector<Segment> segments_;
  std::vector<Cell> cells_;
  std::vector<EndPoint> points_;
  SpanPool<Arm> arms_;
  ChunkPool<Through> throughs_;
  ChunkPool<PlacedEnd> ends_;
  std::size_t through_count_ = 0;  ///< number of entries ever added
};

/// Side of the cells of an index over the strokes numbered in `of`, in lattice steps. It is the median length of the
/// strokes, or their mean distance if that is smaller. Lower bounds: strokes cross at most 64 cells on average, and a
/// cell is larger than the reach of the tolerance.
double index_cell(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance_steps);

/// Side of the cells of a grid through which all strokes are walked, in lattice steps. It is `wanted`, unless the
/// strokes would pass more than 64 cells on average and a quarter of a million in all. Then it is larger by that ratio,
/// so that a very fine pen on a large page needs no more memory than the strokes.
double walked_cell(const std::vector<Stroke>& strokes, double wanted);

}  // namespace ligne

#include "linework/overlaps/stroke_index.inl.hpp"
