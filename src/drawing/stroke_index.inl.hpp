#pragma once
/// The visiting parts of SegmentGrid and StrokeIndex.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "drawing/stroke_index.hpp"
#include "drawing/stroke_overlap.hpp"

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

/// The cells within the tolerance of the segment that are not refined.
template <class Visit>
void StrokeIndex::visit_leaves(std::size_t level, const CellRange& range, LatticePoint from, LatticePoint to,
                               const Visit& visit) {
  levels_[level].grid.walk_cells(from, to, range, [&](std::int32_t column, std::int32_t row) {
    const std::uint32_t c = levels_[level].cells.find(KeyTable::key(column, row));
    if (c == kNone) return false;
    if (cells_[c].refined) {
      visit_leaves(level + 1, parts_of(column, row), from, to, visit);
    } else {
      visit(cells_[c]);
    }
    return false;
  });
}

/// The segments of a list, which forgets those that are erased.
template <class Visit>
void StrokeIndex::visit_links(std::vector<Link>& links, std::uint32_t& first, const Visit& visit) {
  for (std::uint32_t* link = &first; *link != kNone;) {
    Link& l = links[*link];
    if (segments_[l.segment].erased) {
      *link = l.next;
    } else {
      visit(l.segment);
      link = &l.next;
    }
  }
}

/// The points of a cell, which forgets those at which no segment ends any more.
template <class Visit>
void StrokeIndex::visit_points(Cell& cell, const Visit& visit) {
  for (std::uint32_t* link = &cell.first_point; *link != kNone;) {
    EndPoint& point = points_[*link];
    if (point.arms == 0) {
      point.listed = false;
      *link = point.next;
    } else {
      visit(point);
      link = &point.next;
    }
  }
}

template <class Found>
void StrokeIndex::query(LatticePoint from, LatticePoint to, const Found& found) {
  // Segments that pass an end of this one.
  for (const LatticePoint p : {from, to}) {
    const std::uint32_t c = leaf_at(p);
    if (c == kNone) continue;
    const auto visit_near = [&](std::uint32_t segment) {
      const Segment& s = segments_[segment];
      if (levels_[0].grid.near(p, s.from, s.to, s.length)) found(segment);
    };
    visit_links(throughs_, cells_[c].first_through, visit_near);
    visit_points(cells_[c], [&](EndPoint& point) {
      if (point.p != p) visit_links(arms_, point.first_arm, visit_near);
    });
  }
  // Ends along this one.
  const double segment_length = length(from, to);
  visit_leaves(0, {}, from, to, [&](Cell& leaf) {
    visit_points(leaf, [&](EndPoint& point) {
      if (point.p == from || point.p == to || !levels_[0].grid.near(point.p, from, to, segment_length)) return;
      visit_links(arms_, point.first_arm, found);
    });
  });
  // The segment with the same ends.
  const std::uint32_t a = point_table_.find(KeyTable::key(from)), b = point_table_.find(KeyTable::key(to));
  if (a == kNone || b == kNone) return;
  const std::uint32_t same = pair_table_.find(pair_key(a, b));
  if (same != kNone && !segments_[same].erased) found(same);
}

}  // namespace ligne
