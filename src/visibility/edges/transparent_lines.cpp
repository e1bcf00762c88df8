#include "visibility/edges/transparent_lines.hpp"

#include <algorithm>

namespace ligne {

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
  std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
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
