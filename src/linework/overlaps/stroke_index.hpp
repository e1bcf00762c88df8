#pragma once
/// Finds, among segments of the page, those that may lie on a given one.

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

/// Cells are no smaller, in tolerances: the reach of the tolerance is a part of them.
inline constexpr double kLeastCellInTolerances = 8;

/// Cells of a grid, the last ones included; all of them unless told otherwise.
struct CellRange {
  std::int32_t column0 = std::numeric_limits<std::int32_t>::min(), row0 = column0;
  std::int32_t column1 = std::numeric_limits<std::int32_t>::max(), row1 = column1;
};

/// A uniform grid of square cells over the page.
class SegmentGrid {
 public:
  /// Side of the cells, and the distance within which a point counts as on a segment, in lattice steps.
  SegmentGrid(double cell, double tolerance) : cell_(cell), margin_(tolerance + kRounding) {}

  std::uint64_t cell_of(LatticePoint p) const { return KeyTable::key(index(p.x), index(p.y)); }

  /// Calls visit(cell) for every cell within the tolerance of the segment until it returns true; true when it did.
  template <class Visit>
  bool walk(LatticePoint from, LatticePoint to, const Visit& visit) const {
    return walk_cells(from, to, {},
                      [&](std::int32_t column, std::int32_t row) { return visit(KeyTable::key(column, row)); });
  }

  /// Calls visit(column, row) for the cells of a range.
  template <class Visit>
  bool walk_cells(LatticePoint from, LatticePoint to, const CellRange& range, const Visit& visit) const;

  /// The point may lie on the line of the segment.
  bool near(LatticePoint p, LatticePoint from, LatticePoint to, double segment_length) const {
    return std::abs(orientation(from, to, p)) <= margin_ * segment_length;
  }
  /// near() where the length is not known.
  bool near(LatticePoint p, LatticePoint from, LatticePoint to) const {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, area = orientation(from, to, p);
    return area * area <= margin_ * margin_ * (dx * dx + dy * dy);
  }
  /// The point is beside the segment, or no farther from it than the margin along its line.
  bool beside(LatticePoint p, LatticePoint from, LatticePoint to) const {
    const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, squared = dx * dx + dy * dy;
    const double along = dx * (double(p.x) - from.x) + dy * (double(p.y) - from.y),
                 beyond = std::max(-along, along - squared);
    return beyond <= 0 || beyond * beyond <= margin_ * margin_ * squared;
  }

 private:
  static constexpr double kRounding = 2;  ///< steps; more than the rounding of any position worked out here

  std::int32_t index(double v) const { return static_cast<std::int32_t>(std::floor(v / cell_)); }

  double cell_, margin_;
};

/// A grid (kept as a hash table of its cells) over segments, which are numbered as they come in. A cell in which there is a
/// crowd gives what it has to cells of a finer grid.
///
/// Where two segments coincide, each end of their common interval is an end of one of them, and lies on the other. So it
/// is enough to ask which segments pass both ends of the new one, and which ends lie along the new one. A cell therefore
/// keeps two lists: the segments that pass through without ending in it, and the points in it at which segments end, each
/// with its segments. Segments that share an end are met at their other ends, or, when they share both, by a table of the
/// pairs of ends: a point where thousands of segments meet costs each of them nothing. Where hundreds are in a cell few of
/// them are near, so the lists hold the coordinates that tell, side by side.
class StrokeIndex {
 public:
  /// As for SegmentGrid.
  StrokeIndex(double cell, double tolerance) : tolerance_(tolerance) { levels_.emplace_back(cell, tolerance); }

  void insert(LatticePoint from, LatticePoint to);

  /// Segment number `segment` is no longer to be found; it keeps its number.
  void erase(std::uint32_t segment);

  /// Calls found(segment) for every inserted segment that may coincide with from-to, for some more than once, until it
  /// returns true; true when it did.
  template <class Found>
  bool query(LatticePoint from, LatticePoint to, const Found& found) const;

 private:
  struct Segment {
    LatticePoint from, to;
    bool erased = false;
    std::uint32_t ends[2] = {};  ///< its points
    std::uint32_t arms[2] = {};  ///< its places in their lists
  };
  /// A segment that passes through a cell, and a point in it.
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
    bool refined = false;  ///< its lists are those of the cells below
  };
  /// A grid; cells of the next one are kParts times as small.
  struct Level {
    Level(double cell_side, double tolerance) : side(cell_side), grid(cell_side, tolerance) {}
    double side;
    SegmentGrid grid;
    KeyTable cells;
  };
  struct EndPoint {
    LatticePoint p;
    SpanPool<Arm>::List arms{};
    bool listed = true;  ///< in the list of its cell
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
  void refine_if_crowded(std::size_t level, std::uint64_t key, std::uint32_t cell);
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
  std::size_t through_count_ = 0;  ///< ever listed
};

/// Side of the cells of an index over the strokes numbered in `of`, in steps: as small as the common stroke, or as the mean
/// distance of strokes when these are long, but never so small that the strokes cross more than 64 of them on the average,
/// and always larger than the reach of the tolerance.
double index_cell(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance_steps);

/// Side of the cells of a grid that all strokes are walked through, in steps: `wanted`, unless they would pass more than
/// 64 cells on the average and a quarter of a million in all. Then it is so much larger: a hair of a pen on a large page
/// asks for no more memory than the strokes.
double walked_cell(const std::vector<Stroke>& strokes, double wanted);

}  // namespace ligne

#include "linework/overlaps/stroke_index.inl.hpp"
