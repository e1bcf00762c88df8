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
                               const Visit& visit) const {
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

template <class Found>
void StrokeIndex::query(LatticePoint from, LatticePoint to, const Found& found) const {
  // Segments that pass an end of this one.
  for (const LatticePoint p : {from, to}) {
    const std::uint32_t c = leaf_at(p);
    if (c == kNone) continue;
    const auto visit_near = [&](const std::vector<Link>& links, std::uint32_t first) {
      for (std::uint32_t i = first; i != kNone; i = links[i].next) {
        const Segment& s = segments_[links[i].segment];
        if (levels_[0].grid.near(p, s.from, s.to, s.length)) found(links[i].segment);
      }
    };
    visit_near(throughs_, cells_[c].first_through);
    for (std::uint32_t e = cells_[c].first_point; e != kNone; e = points_[e].next) {
      if (points_[e].p != p) visit_near(arms_, points_[e].first_arm);
    }
  }
  // Ends along this one.
  const double segment_length = length(from, to);
  visit_leaves(0, {}, from, to, [&](const Cell& leaf) {
    for (std::uint32_t e = leaf.first_point; e != kNone; e = points_[e].next) {
      const LatticePoint p = points_[e].p;
      if (p == from || p == to || !levels_[0].grid.near(p, from, to, segment_length)) continue;
      for (std::uint32_t i = points_[e].first_arm; i != kNone; i = arms_[i].next) found(arms_[i].segment);
    }
  });
  // The segment with the same ends.
  const std::uint32_t a = point_table_.find(KeyTable::key(from)), b = point_table_.find(KeyTable::key(to));
  if (a == kNone || b == kNone) return;
  const std::uint32_t same = pair_table_.find(pair_key(a, b));
  if (same != kNone) found(same);
}

}  // namespace ligne
