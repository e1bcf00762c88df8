#include "visibility/common/visible_parts.hpp"

#include <algorithm>

namespace ligne {

std::vector<LinePart>& VisibleParts::find(const PageLine& line) {
  parts_.clear();
  near_side_ = false;
  if (ranks_) rank_ = ranks_->rank_of(line);
  grid_.for_each_leaf(line, [&](const Cell& cell, const CellSquare& square, double from, double to) {
    ++counts_.leaves;
    if (cell.occluder_depth < line.z(from) && cell.occluder_depth < line.z(to)) {
      ++counts_.covered;
      return;
    }
    if (cell.one_face && cell.count > 0 && is_own(line, grid_.list(cell)->facet)) {
      append_part(parts_, {from, to});
    } else {
      search_leaf(line, cell, square, from, to);
    }
  });
  return parts_;
}

/// Whether a side of the facet may lie along the line: two corners are near it, or the line is near a side.
bool VisibleParts::has_side_along(const PageLine& line, const Facet& facet) const {
  const double close = coincidence_steps_ * std::max<double>(line.size, facet.size);
  int near = 0;
  for (const std::uint32_t v : facet.v) near += std::abs(orientation(line.p0, line.p1, vertices_[v].p)) <= close;
  return near >= 2;
}

void VisibleParts::search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from, double to) {
  open_.reset(from, to);
  const double z_far = std::max(line.z(from), line.z(to));
  const double x0 = line.p0.x + from * line.dx, x1 = line.p0.x + to * line.dx;
  const double y0 = line.p0.y + from * line.dy, y1 = line.p0.y + to * line.dy;
  const CellBox box = square.box(std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1));
  const CellFacet* entry = grid_.list(cell);
  const CellFacet* const end = entry + cell.count;
  for (; entry != end && entry->z_near <= z_far; ++entry) {
    if (!entry->box.meets(box)) continue;
    if (is_own(line, entry->facet)) continue;
    const Facet& facet = facets_[entry->facet];
    if (ranks_ && ranks_->begins_behind(facet.face, rank_) && !has_side_along(line, facet)) {
      ++counts_.behind_in_order;
      continue;
    }
    ++counts_.facet_tests;
    const HiddenInterval hidden =
        hidden_interval(line, facet, vertices_, open_.from(), open_.to(), coincidence_steps_, near_side_);
    open_.take(hidden);
    if (open_.empty()) return;
  }
  for (const LinePart& part : open_.finish()) append_part(parts_, part);
}

}  // namespace ligne
