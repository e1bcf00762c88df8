#include "visibility/warnock/areas.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ligne::warnock {
namespace {

Boundary boundary(FramePoint a, FramePoint b) {
  const bool swapped = a.u > b.u || (a.u == b.u && a.v > b.v);
  return swapped ? Boundary{b, a} : Boundary{a, b};
}

/// Boundaries closer than this, relative to their v, coincide: a bound on the rounding of Boundary::v().
constexpr double kSamePlace = 0x1p-40;

bool same_place(double a, double b) { return std::abs(a - b) <= kSamePlace * (1 + std::abs(a) + std::abs(b)); }

bool in_facet(const FaceTable& table, const Facet& f, double u, double v) {
  for (int i = 0; i < 3; ++i) {
    const FramePoint p = table.at(f.v[i]), q = table.at(f.v[(i + 1) % 3]);
    if ((q.u - p.u) * (v - p.v) - (q.v - p.v) * (u - p.u) < 0) return false;
  }
  return true;
}

}  // namespace

double Boundary::v(double u) const {
  if (u == p.u || p.u == q.u) return p.v;
  if (u == q.u) return q.v;
  return p.v + (u - p.u) * ((q.v - p.v) / (q.u - p.u));
}

std::uint32_t AreaSearch::front_at(const Lists& lists, double u, double v) const {
  const Face* front = nullptr;
  double front_z = 0;
  for (const Element& e : lists.elements) {
    const Face& face = table_.faces[e.face];
    if (front && e.near > front_z + front->slack) continue;
    if (e.relation != Relation::surrounder) {
      if (u < face.box.u0 || u > face.box.u1 || v < face.box.v0 || v > face.box.v1) continue;
      const auto facets = table_.facets_of(face);
      if (std::ranges::none_of(facets, [&](std::uint32_t id) { return in_facet(table_, (*table_.facets)[id], u, v); }))
        continue;
    }
    const double z = face.z(u, v);
    if (front) {
      // Touching faces have equal depths within the tolerance: the one with the lowest number wins.
      const double tolerance = std::max(front->slack, face.slack);
      if (z > front_z + tolerance || (z >= front_z - tolerance && face.face > front->face)) continue;
    }
    front = &face;
    front_z = z;
  }
  return front ? front->face : kNone;
}

void AreaSearch::add_segment(FramePoint a, FramePoint b, const Window& w) {
  const Boundary s = boundary(a, b);
  if (s.q.u < w.u0 || s.p.u > w.u1 || std::max(s.p.v, s.q.v) < w.v0 || std::min(s.p.v, s.q.v) > w.v1) return;
  double u0 = std::max(s.p.u, w.u0), u1 = std::min(s.q.u, w.u1);
  events_.push_back(u0);
  events_.push_back(u1);
  if (s.p.u == s.q.u) return;  // vertical: ends slabs, but bounds no trapezoid
  // Crossings with the lower and the upper border of the window.
  for (const double border : {w.v0, w.v1}) {
    if ((s.p.v < border) == (s.q.v < border)) continue;
    const double u = s.p.u + (border - s.p.v) * ((s.q.u - s.p.u) / (s.q.v - s.p.v));
    if (u > w.u0 && u < w.u1) events_.push_back(u);
  }
  segments_.push_back({s.p, s.q, u0, u1});
}

void AreaSearch::find_crossings(const Window& w) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& a = segments_[i];
    for (std::size_t k = i + 1; k < segments_.size(); ++k) {
      const Segment& b = segments_[k];
      if (std::max(a.u0, b.u0) >= std::min(a.u1, b.u1)) continue;
      const int p = turn(a.p, a.q, b.p), q = turn(a.p, a.q, b.q);
      if (p * q >= 0 || turn(b.p, b.q, a.p) * turn(b.p, b.q, a.q) > 0) continue;
      const double du = a.q.u - a.p.u, dv = a.q.v - a.p.v;
      const double h0 = du * (b.p.v - a.p.v) - dv * (b.p.u - a.p.u), h1 = du * (b.q.v - a.p.v) - dv * (b.q.u - a.p.u);
      const double u = b.p.u + h0 / (h0 - h1) * (b.q.u - b.p.u);
      if (u > w.u0 && u < w.u1) events_.push_back(u);
    }
  }
}

void AreaSearch::collect(const Lists& lists, const Window& w, std::span<const Piece> intersections) {
  segments_.clear();
  events_.assign({w.u0, w.u1});
  for (const Element& e : lists.elements) {
    if (e.relation != Relation::intersector) continue;
    for (const Side& s : table_.sides_of(table_.faces[e.face])) {
      const FramePoint p = table_.at(s.v0), q = table_.at(s.v1);
      if (meets(p, q, w)) add_segment(p, q, w);
    }
  }
  for (const Piece& piece : intersections) {
    const PageLine& line = lines_[piece.line];
    add_segment(table_.frame(line.p0), table_.frame(line.p1), w);
  }
  // Adjacent faces list their common edge twice.
  std::ranges::sort(segments_, [](const Segment& a, const Segment& b) {
    return std::tie(a.p.u, a.p.v, a.q.u, a.q.v) < std::tie(b.p.u, b.p.v, b.q.u, b.q.v);
  });
  segments_.erase(std::unique(segments_.begin(), segments_.end(),
                              [](const Segment& a, const Segment& b) {
                                return Boundary{a.p, a.q} == Boundary{b.p, b.q};
                              }),
                  segments_.end());
  find_crossings(w);
  std::ranges::sort(events_);
  events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
}

void AreaSearch::find(const Lists& lists, const Window& w, std::span<const Piece> intersections,
                      std::vector<AreaPiece>& out) {
  collect(lists, w, intersections);
  const Boundary below{{w.u0, w.v0}, {w.u1, w.v0}}, above{{w.u0, w.v1}, {w.u1, w.v1}};
  struct Crossed {
    Boundary line;
    double v;
  };
  std::vector<Crossed> crossed;
  std::vector<AreaPiece> open, next;  // pieces that end at the slab's first u; pieces that end at its last u
  for (std::size_t i = 0; i + 1 < events_.size(); ++i) {
    const double u0 = events_[i], u1 = events_[i + 1], middle = u0 + (u1 - u0) / 2;
    crossed.clear();
    for (const Segment& s : segments_) {
      if (s.u0 > u0 || s.u1 < u1) continue;
      const Boundary line{s.p, s.q};
      const double v = line.v(middle);
      if (v > w.v0 && v < w.v1 && !same_place(v, w.v0) && !same_place(v, w.v1)) crossed.push_back({line, v});
    }
    std::ranges::stable_sort(crossed, [](const Crossed& a, const Crossed& b) { return a.v < b.v; });
    crossed.push_back({above, w.v1});
    next.clear();
    AreaPiece piece{u0, u1, below, below, kNone};
    double v = w.v0;
    bool begun = false;
    for (const Crossed& c : crossed) {
      if (same_place(c.v, v)) continue;
      const std::uint32_t face = front_at(lists, middle, v + (c.v - v) / 2);
      if (begun && face == piece.face) {
        piece.high = c.line;
      } else {
        if (begun) next.push_back(piece);
        piece = {u0, u1, begun ? piece.high : below, c.line, face};
        begun = true;
      }
      v = c.v;
    }
    if (begun) next.push_back(piece);
    // Merges pieces that continue with the same bounds.
    for (AreaPiece& p : next) {
      const auto before = std::ranges::find_if(
          open, [&](const AreaPiece& o) { return o.face == p.face && o.low == p.low && o.high == p.high; });
      if (before == open.end()) continue;
      p.u0 = before->u0;
      open.erase(before);
    }
    for (const AreaPiece& p : open) {
      if (p.face != kNone) out.push_back(p);
    }
    open.swap(next);
  }
  for (const AreaPiece& p : open) {
    if (p.face != kNone) out.push_back(p);
  }
}

void AreaSearch::take_front(const Lists& lists, const Window& w, std::vector<AreaPiece>& out) const {
  const std::uint32_t face = front_at(lists, (w.u0 + w.u1) / 2, (w.v0 + w.v1) / 2);
  if (face == kNone || !(w.u0 < w.u1 && w.v0 < w.v1)) return;
  out.push_back({w.u0, w.u1, {{w.u0, w.v0}, {w.u1, w.v0}}, {{w.u0, w.v1}, {w.u1, w.v1}}, face});
}

}  // namespace ligne::warnock
