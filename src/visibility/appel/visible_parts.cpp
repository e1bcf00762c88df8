#include "visibility/appel/visible_parts.hpp"

#include <algorithm>

namespace ligne::appel {

std::vector<Part>& VisibleParts::find(const Line& line) {
  parts_.clear();
  near_side_ = false;
  grid_.for_each_leaf(line, [&](const Cell& cell, const CellSquare& square, double from, double to) {
    ++counts_.leaves;
    if (cell.cover < line.z(from) && cell.cover < line.z(to)) {
      ++counts_.covered;
      return;
    }
    search_leaf(line, cell, square, from, to);
  });
  return parts_;
}

void VisibleParts::search_leaf(const Line& line, const Cell& cell, const CellSquare& square, double from, double to) {
  open_.assign(1, {from, to});
  one_sided_.clear();
  const double z_far = std::max(line.z(from), line.z(to));
  const double x0 = line.p0.x + from * line.dx, x1 = line.p0.x + to * line.dx;
  const double y0 = line.p0.y + from * line.dy, y1 = line.p0.y + to * line.dy;
  const CellBox box = square.box(std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1));
  const CellFacet* entry = grid_.list(cell);
  const CellFacet* const end = entry + cell.count;
  for (; entry != end && entry->z_near <= z_far; ++entry) {
    if (!entry->box.meets(box)) continue;
    const Facet& facet = facets_[entry->facet];
    if (facet.face == line.face0 || facet.face == line.face1) continue;
    ++counts_.facet_tests;
    const HiddenInterval hidden =
        hidden_interval(line, facet, vertices_, open_.front().from, open_.back().to, coincidence_steps_, near_side_);
    if (hidden.bank == Bank::both) {
      take(hidden.from, hidden.to);
      if (open_.empty()) return;
    } else if (hidden.bank != Bank::none) {
      one_sided_.push_back(hidden);
    }
  }
  if (one_sided_.size() > 1) take_one_sided();
  for (const Part& part : open_) {
    if (!parts_.empty() && parts_.back().to == part.from) {
      parts_.back().to = part.to;
    } else {
      parts_.push_back(part);
    }
  }
}

void VisibleParts::take(double from, double to) {
  spare_.clear();
  for (const Part& part : open_) {
    if (to <= part.from || from >= part.to) {
      spare_.push_back(part);
      continue;
    }
    if (part.from < from) spare_.push_back({part.from, from});
    if (to < part.to) spare_.push_back({to, part.to});
  }
  open_.swap(spare_);
}

/// Hides what is covered on the left and on the right. Both unions are swept together.
void VisibleParts::take_one_sided() {
  struct Event {
    double t;
    int left, right;
  };
  std::vector<Event> events;
  for (const HiddenInterval& h : one_sided_) {
    const bool left = h.bank == Bank::left;
    events.push_back({h.from, left ? 1 : 0, left ? 0 : 1});
    events.push_back({h.to, left ? -1 : 0, left ? 0 : -1});
  }
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
  int left = 0, right = 0;
  for (std::size_t i = 0; i + 1 < events.size() && !open_.empty(); ++i) {
    left += events[i].left;
    right += events[i].right;
    if (left > 0 && right > 0 && events[i].t < events[i + 1].t) take(events[i].t, events[i + 1].t);
  }
}

}  // namespace ligne::appel
