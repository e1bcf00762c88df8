#include "visibility/warnock/solution.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::warnock {

void Solution::load(const Lists& lists, const Window& window) {
  items_.clear();
  const Window larger = window.grown(std::ceil(margin_steps_ * table_.frame.unit()));
  const auto& vertices = *table_.vertices;
  const auto margin = static_cast<std::int32_t>(std::ceil(margin_steps_));
  for (const Element& e : lists.elements) {
    const Face& face = table_.faces[e.face];
    const auto facets = table_.facets_of(face);
    for (const std::uint32_t id : facets) {
      const Facet& f = (*table_.facets)[id];
      if (facets.size() > 1) {
        const FramePoint a = table_.at(f.v[0]), b = table_.at(f.v[1]), c = table_.at(f.v[2]);
        const Window box{std::min({a.u, b.u, c.u}), std::max({a.u, b.u, c.u}), std::min({a.v, b.v, c.v}),
                         std::max({a.v, b.v, c.v})};
        if (!box.meets(larger)) continue;
      }
      const LatticePoint p = vertices[f.v[0]].p, q = vertices[f.v[1]].p, r = vertices[f.v[2]].p;
      items_.push_back({id, f.z_near, f.z_far, std::min({p.x, q.x, r.x}) - margin, std::max({p.x, q.x, r.x}) + margin,
                        std::min({p.y, q.y, r.y}) - margin, std::max({p.y, q.y, r.y}) + margin});
    }
  }
  std::sort(items_.begin(), items_.end(),
            [](const Item& a, const Item& b) { return a.z_near != b.z_near ? a.z_near < b.z_near : a.facet < b.facet; });
}

/// The operation uses the whole line and its result is clipped to the piece, so that visibility does not depend on the
/// windows.
template <class Visit>
bool Solution::visit_hidden(const Piece& piece, bool& near_side, Visit visit) {
  const PageLine& line = lines_[piece.line];
  const double xa = line.p0.x + piece.from * line.dx, xb = line.p0.x + piece.to * line.dx;
  const double ya = line.p0.y + piece.from * line.dy, yb = line.p0.y + piece.to * line.dy;
  const double x0 = std::min(xa, xb), x1 = std::max(xa, xb), y0 = std::min(ya, yb), y1 = std::max(ya, yb);
  const double z_far = std::max(line.z(piece.from), line.z(piece.to));
  for (const Item& item : items_) {
    if (item.z_near > z_far) break;
    if (item.x0 > x1 || item.x1 < x0 || item.y0 > y1 || item.y1 < y0) continue;
    const Facet& facet = (*table_.facets)[item.facet];
    if (facet.face == line.face0 || facet.face == line.face1) continue;
    ++counts_.line_facet_tests;
    HiddenInterval hidden = hidden_interval(line, facet, table_.vertices->data(), {0, 1}, coincidence_steps_, near_side);
    if (hidden.sides == HiddenSides::none) continue;
    hidden.from = std::max(hidden.from, piece.from);
    hidden.to = std::min(hidden.to, piece.to);
    if (hidden.from < hidden.to && visit(hidden)) return true;
  }
  return false;
}

void Solution::draw_lines(std::span<const Piece> pieces, std::vector<FoundPart>& out) {
  for (const Piece& piece : pieces) {
    bool near_side = false;
    open_.reset(piece.from, piece.to);
    const bool hidden = visit_hidden(piece, near_side, [&](const HiddenInterval& h) {
      open_.take(h);
      return open_.empty();
    });
    if (hidden) continue;
    for (const LinePart& part : open_.finish()) out.push_back({piece.line, near_side, part});
  }
}

void Solution::draw_by_middle(std::span<const Piece> pieces, std::vector<FoundPart>& out) {
  for (const Piece& piece : pieces) {
    const double middle = piece.from + (piece.to - piece.from) / 2;
    bool left = false, right = false, near_side = false;
    const bool hidden = visit_hidden(piece, near_side, [&](const HiddenInterval& h) {
      if (middle < h.from || middle >= h.to) return false;
      left |= h.sides != HiddenSides::right;
      right |= h.sides != HiddenSides::left;
      return left && right;
    });
    if (!hidden) out.push_back({piece.line, near_side, {piece.from, piece.to}});
  }
}

void Solution::find_pairs(const Window& window, float cover, PenetrationSearch& found) {
  if (items_.size() < 2) return;
  placed_.clear();
  for (const Item& item : items_) placed_.push_back(found.place(item.facet));
  const Window larger = window.grown(std::ceil(margin_steps_ * table_.frame.unit()));
  const WindowFrame& frame = table_.frame;
  const auto wanted = [&](const PageSegment& s) {
    if (std::isinf(cover)) return true;
    const auto u = [&](const PagePoint& p) { return frame.a * p.x + frame.b * p.y; };
    const auto v = [&](const PagePoint& p) { return frame.a * p.y - frame.b * p.x; };
    const double u0 = u(s.from), u1 = u(s.to), v0 = v(s.from), v1 = v(s.to);
    const auto part = clip_parameters<4>({u0 - larger.u0, larger.u1 - u0, v0 - larger.v0, larger.v1 - v0},
                                         {u1 - larger.u0, larger.u1 - u1, v1 - larger.v0, larger.v1 - v1});
    return part && !(s.at((*part)[0]).z > cover && s.at((*part)[1]).z > cover);
  };
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& a = items_[i];
    for (std::size_t k = i + 1; k < items_.size(); ++k) {
      const Item& b = items_[k];
      if (b.z_near > a.z_far) break;
      if (a.x0 > b.x1 || b.x0 > a.x1 || a.y0 > b.y1 || b.y0 > a.y1 || placed_[i].face == placed_[k].face) continue;
      ++counts_.pair_tests;
      found.test(placed_[i], placed_[k], wanted);
    }
  }
}

}  // namespace ligne::warnock
