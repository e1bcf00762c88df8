#pragma once
/// Templates of SegmentGrid and StrokeIndex that visit cells and segments.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/no_index.hpp"
#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne {

template <class Visit>
bool SegmentGrid::walk_cells(LatticePoint from, LatticePoint to, const CellRange& range, const Visit& visit) const {
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y;
  // Slab by slab along the longer direction, called u here; v is the other one, and |dv/du| <= 1.
  const bool flat = std::abs(dx) >= std::abs(dy);
  const double u0 = flat ? from.x : from.y, v0 = flat ? from.y : from.x;
  const double u1 = flat ? to.x : to.y;
  const double slope = dx == 0 && dy == 0 ? 0 : flat ? dy / dx : dx / dy;
  const double u_min = std::min(u0, u1), u_max = std::max(u0, u1);
  const std::int32_t i_first = std::max(index(u_min - margin_), flat ? range.column0 : range.row0);
  const std::int32_t i_last = std::min(index(u_max + margin_), flat ? range.column1 : range.row1);
  for (std::int32_t i = i_first; i <= i_last; ++i) {
    const double slab_from = std::clamp(i * cell_ - margin_, u_min, u_max);
    const double slab_to = std::clamp((i + 1) * cell_ + margin_, u_min, u_max);
    const double v_from = v0 + (slab_from - u0) * slope, v_to = v0 + (slab_to - u0) * slope;
    const std::int32_t j_first = std::max(index(std::min(v_from, v_to) - margin_), flat ? range.row0 : range.column0);
    const std::int32_t j_last = std::min(index(std::max(v_from, v_to) + margin_), flat ? range.row1 : range.column1);
    for (std::int32_t j = j_first; j <= j_last; ++j) {
      if (flat ? visit(i, j) : visit(j, i)) return true;
    }
  }
  return false;
}

/// Calls visit(leaf) for each leaf within the tolerance of the segment, until it returns true.
template <class Visit>
bool StrokeIndex::visit_leaves(std::size_t level, const CellRange& range, LatticePoint from, LatticePoint to,
                               const Visit& visit) const {
  return levels_[level].grid.walk_cells(from, to, range, [&](std::int32_t column, std::int32_t row) {
    const std::uint32_t c = levels_[level].cells.find(KeyTable::key(column, row));
    if (c == kNone) return false;
    return cells_[c].refined ? visit_leaves(level + 1, parts_of(column, row), from, to, visit) : visit(cells_[c]);
  });
}

/// Whether the two points are certainly farther apart than the distance, in spite of their rounding.
inline bool is_farther(LatticePoint a, LatticePoint b, double distance) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, least = std::max(0.0, distance - 1);
  return dx * dx + dy * dy > least * least;
}

/// Whether q lies on the same side of p as `towards`.
inline bool is_ahead(LatticePoint p, LatticePoint towards, LatticePoint q) {
  return (double(towards.x) - p.x) * (double(q.x) - p.x) + (double(towards.y) - p.y) * (double(q.y) - p.y) > 0;
}

/// Finds the segments that pass through the cell or end in it, but not at p, and are near both p and the other point.
template <class Found>
bool StrokeIndex::visit_passing(const Cell& cell, LatticePoint p, LatticePoint other, const Found& found) const {
  const SegmentGrid& grid = levels_[0].grid;
  const auto visit_through = [&](const Through& t) {
    return grid.near(p, t.from, t.to) && grid.near(other, t.from, t.to) && !segments_[t.segment].erased && found(t.segment);
  };
  if (throughs_.visit(cell.throughs, visit_through)) return true;
  return ends_.visit(cell.ends, [&](const PlacedEnd& end) {
    if (end.p == p) return false;
    for (const Arm& arm : arms_.items(points_[end.point].arms)) {
      if (grid.near(p, end.p, arm.far) && grid.near(other, end.p, arm.far) && found(arm.segment)) return true;
    }
    return false;
  });
}

/// Finds the segments with an end in the cell that is near from-to but not at its ends.
template <class Found>
bool StrokeIndex::visit_along(const Cell& cell, LatticePoint from, LatticePoint to, const Found& found) const {
  const SegmentGrid& grid = levels_[0].grid;
  return ends_.visit(cell.ends, [&](const PlacedEnd& end) {
    if (!grid.near(end.p, from, to) || end.p == from || end.p == to) return false;
    // The other end of the common interval is the far end, or an end of from-to that is farther away than the
    // tolerance.
    const bool from_is_far = is_farther(end.p, from, tolerance_), to_is_far = is_farther(end.p, to, tolerance_);
    for (const Arm& arm : arms_.items(points_[end.point].arms)) {
      const bool may_lie = (grid.near(arm.far, from, to) && grid.beside(arm.far, from, to)) ||
                           (from_is_far && is_ahead(end.p, arm.far, from) && grid.near(from, end.p, arm.far)) ||
                           (to_is_far && is_ahead(end.p, arm.far, to) && grid.near(to, end.p, arm.far));
      if (may_lie && found(arm.segment)) return true;
    }
    return false;
  });
}

template <class Found>
bool StrokeIndex::query(LatticePoint from, LatticePoint to, const Found& found) const {
  for (const auto& [p, other] : {std::pair(from, to), std::pair(to, from)}) {
    if (const std::uint32_t c = leaf_at(p); c != kNone && visit_passing(cells_[c], p, other, found)) return true;
  }
  if (visit_leaves(0, {}, from, to, [&](const Cell& leaf) { return visit_along(leaf, from, to, found); })) return true;
  // Looks up the segment with the same two ends.
  const std::uint32_t a = point_table_.find(KeyTable::key(from)), b = point_table_.find(KeyTable::key(to));
  if (a == kNone || b == kNone) return false;
  const std::uint32_t same = pair_table_.find(pair_key(a, b));
  return same != kNone && !segments_[same].erased && found(same);
}

}  // namespace ligne
