#include "visibility/edges/visible_parts.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// Relative rounding error of two depths interpolated along a line and along a side: about two dozen roundings.
constexpr double kSideDepthRounding = 0x1p-46;

}  // namespace

std::vector<LinePart>& VisibleParts::find(const PageLine& line) {
  parts_.clear();
  near_.clear();
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
  if (blank_) blank_->take_from(parts_, line);
  if (only_visible_) {
    near_side_ = std::ranges::any_of(near_, [&](std::uint32_t facet) { return has_side_along_part(line, facets_[facet]); });
  }
  return parts_;
}

/// Whether a side of the facet may lie along the line: two corners are near it, or the line is near a side.
bool VisibleParts::has_side_along(const PageLine& line, const Facet& facet) const {
  const double close = coincidence_steps_ * std::max<double>(line.size, facet.size);
  int near = 0;
  for (const std::uint32_t v : facet.v) near += std::abs(orientation(line.p0, line.p1, vertices_[v].p)) <= close;
  return near >= 2;
}

/// Whether a side of the facet lies along a visible part of the line, over more than the coincidence distance, and is
/// not behind it at one end of the common part at least. For two coincident lines this holds for at least one of them.
bool VisibleParts::has_side_along_part(const PageLine& line, const Facet& facet) const {
  const double limit = coincidence_steps_ * line.size, square = line.dx * line.dx + line.dy * line.dy;
  const double least = coincidence_steps_ / std::sqrt(square);
  for (int i = 0; i < 3; ++i) {
    const ProjectedVertex &a = vertices_[facet.v[i]], &b = vertices_[facet.v[i == 2 ? 0 : i + 1]];
    const double side_limit = coincidence_steps_ * (std::abs(double(b.p.x) - a.p.x) + std::abs(double(b.p.y) - a.p.y));
    const bool on_line =
        std::abs(orientation(line.p0, line.p1, a.p)) <= limit && std::abs(orientation(line.p0, line.p1, b.p)) <= limit;
    const bool line_on =
        std::abs(orientation(a.p, b.p, line.p0)) <= side_limit && std::abs(orientation(a.p, b.p, line.p1)) <= side_limit;
    if (!on_line && !line_on) continue;
    const auto place = [&](LatticePoint p) {
      return ((double(p.x) - line.p0.x) * line.dx + (double(p.y) - line.p0.y) * line.dy) / square;
    };
    const double ta = place(a.p), tb = place(b.p);
    if (ta == tb) continue;
    const auto not_behind = [&](double t) {
      const double z = a.z + (t - ta) / (tb - ta) * (b.z - a.z), z_line = line.z(t);
      return z <= z_line + kSideDepthRounding * (std::abs(z) + std::abs(z_line));
    };
    for (const LinePart& part : parts_) {
      const double from = std::max(part.from, std::min(ta, tb)), to = std::min(part.to, std::max(ta, tb));
      if (to - from > least && (not_behind(from) || not_behind(to))) return true;
    }
  }
  return false;
}

void VisibleParts::search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from, double to) {
  open_.reset(from, to);
  const double z_far = std::max(line.z(from), line.z(to));
  const double x0 = line.p0.x + from * line.dx, x1 = line.p0.x + to * line.dx;
  const double y0 = line.p0.y + from * line.dy, y1 = line.p0.y + to * line.dy;
  const CellBox box = square.box(std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1));
  const bool in_plane = cell.one_plane && grid_.plane_of(cell).holds(line);
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
    // A facet in the plane of the line does not hide it, but may have a side along it.
    if (in_plane && !has_side_along(line, facet)) continue;
    ++counts_.facet_tests;
    bool near = false;
    const HiddenInterval hidden =
        hidden_interval(line, facet, vertices_, {open_.from(), open_.to()}, coincidence_steps_, near);
    if (near && only_visible_) near_.push_back(entry->facet);
    near_side_ |= near;
    open_.take(hidden);
    if (open_.empty()) return;
  }
  for (const LinePart& part : open_.finish()) append_part(parts_, part);
}

std::vector<LinePart>& TransparentLines::find(const PageLine& line) {
  parts_.clear();
  grid_.for_each_leaf(line, [&](const Cell& cell, const CellSquare& square, double from, double to) {
    search_leaf(line, cell, square, from, to);
  });
  return parts_;
}

void TransparentLines::search_leaf(const PageLine& line, const Cell& cell, const CellSquare& square, double from,
                                   double to) {
  if (cell.occluder_depth < line.z(from) && cell.occluder_depth < line.z(to)) return;
  events_.assign({{from, 0, 0, 0, 0}, {to, 0, 0, 0, 0}});
  const double z_far = std::max(line.z(from), line.z(to));
  const double x0 = line.p0.x + from * line.dx, x1 = line.p0.x + to * line.dx, y0 = line.p0.y + from * line.dy,
               y1 = line.p0.y + to * line.dy;
  const CellBox box = square.box(std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1));
  const CellFacet* entry = grid_.list(cell);
  for (const CellFacet* const end = entry + cell.count; entry != end && entry->z_near <= z_far; ++entry) {
    if (!entry->box.meets(box)) continue;
    const Facet& facet = facets_[entry->facet];
    if (facet.face == line.face0 || facet.face == line.face1) continue;
    bool near_side = false;
    const HiddenInterval hidden =
        hidden_interval(line, facet, scene_.vertices.data(), {from, to}, coincidence_steps_, near_side);
    if (hidden.sides == HiddenSides::none) continue;
    const int left = hidden.sides != HiddenSides::right, right = hidden.sides != HiddenSides::left;
    const bool transparent = scene_.face_is_transparent[facet.face] != 0;
    events_.push_back({hidden.from, transparent * left, transparent * right, !transparent * left, !transparent * right});
    events_.push_back({hidden.to, -transparent * left, -transparent * right, -!transparent * left, -!transparent * right});
  }
  std::ranges::stable_sort(events_, [](const Event& a, const Event& b) { return a.t < b.t; });
  int left = 0, right = 0, hidden_left = 0, hidden_right = 0;
  for (std::size_t i = 0; i + 1 < events_.size(); ++i) {
    left += events_[i].left;
    right += events_[i].right;
    hidden_left += events_[i].hidden_left;
    hidden_right += events_[i].hidden_right;
    if (!(events_[i].t < events_[i + 1].t) || (hidden_left > 0 && hidden_right > 0)) continue;
    const int level = hidden_left > 0 ? right : hidden_right > 0 ? left : std::min(left, right);
    append_part(parts_, {events_[i].t, events_[i + 1].t, static_cast<std::uint32_t>(std::max(level, 0))});
  }
}

}  // namespace ligne
