#include "visibility/warnock/regions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/disjoint_sets.hpp"

namespace ligne::warnock {
namespace {

/// A directed piece of a contour. The region lies on its positive side.
struct DirectedEdge {
  FramePoint from, to;
  std::uint32_t piece = 0;
};

/// An interval on a line of constant u or v, on the low or high side of which its trapezoid lies.
struct Interval {
  double line, from, to;
  bool high_side;
  std::uint32_t piece;
};

/// The intervals that remain after those of one face on both sides of a line have cancelled, and joins their groups.
std::vector<Interval> cancel(std::vector<Interval> all, const std::vector<AreaPiece>& pieces, DisjointSets& groups) {
  std::erase_if(all, [](const Interval& i) { return !(i.from < i.to); });
  const auto face = [&](const Interval& i) { return pieces[i.piece].face; };
  std::sort(all.begin(), all.end(), [&](const Interval& a, const Interval& b) {
    return std::tuple(a.line, face(a), a.high_side, a.from, a.to, a.piece) <
           std::tuple(b.line, face(b), b.high_side, b.from, b.to, b.piece);
  });
  std::vector<Interval> left;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t middle = i, end = i;
    const auto together = [&](const Interval& o) { return o.line == all[i].line && face(o) == face(all[i]); };
    while (middle < all.size() && together(all[middle]) && !all[middle].high_side) ++middle;
    end = middle;
    while (end < all.size() && together(all[end])) ++end;
    // Both runs are sorted; their first intervals a and b lose their overlap.
    std::size_t a = i, b = middle;
    while (a < middle && b < end) {
      Interval &l = all[a], &h = all[b];
      if (l.to <= h.from) {
        left.push_back(l);
        ++a;
      } else if (h.to <= l.from) {
        left.push_back(h);
        ++b;
      } else {
        groups.join(l.piece, h.piece);
        Interval& first = l.from < h.from ? l : h;
        const double from = std::max(l.from, h.from), to = std::min(l.to, h.to);
        if (first.from < from) left.push_back({first.line, first.from, from, first.high_side, first.piece});
        l.from = h.from = to;
        if (!(l.from < l.to)) ++a;
        if (!(h.from < h.to)) ++b;
      }
    }
    for (; a < middle; ++a) left.push_back(all[a]);
    for (; b < end; ++b) left.push_back(all[b]);
    i = end;
  }
  return left;
}

bool level(const Boundary& b) { return b.p.v == b.q.v; }

std::vector<DirectedEdge> contour_edges(const std::vector<AreaPiece>& pieces, DisjointSets& groups) {
  std::vector<DirectedEdge> edges;
  std::vector<Interval> upright, flat;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const AreaPiece& p = pieces[i];
    const double low0 = p.low.v(p.u0), low1 = p.low.v(p.u1), high0 = p.high.v(p.u0), high1 = p.high.v(p.u1);
    // The piece is on the low side of the line at u1, and on the high side of the line at u0.
    upright.push_back({p.u1, low1, high1, false, i});
    upright.push_back({p.u0, low0, high0, true, i});
    // If rounding has swapped the corners, the border runs backwards there.
    if (low1 > high1) edges.push_back({{p.u1, low1}, {p.u1, high1}, i});
    if (low0 > high0) edges.push_back({{p.u0, high0}, {p.u0, low0}, i});
    if (level(p.low)) {
      flat.push_back({p.low.p.v, p.u0, p.u1, true, i});
    } else {
      edges.push_back({{p.u0, low0}, {p.u1, low1}, i});
    }
    if (level(p.high)) {
      flat.push_back({p.high.p.v, p.u0, p.u1, false, i});
    } else {
      edges.push_back({{p.u1, high1}, {p.u0, high0}, i});
    }
  }
  const auto add = [&](std::vector<Interval> intervals, bool is_upright) {
    for (const Interval& i : cancel(std::move(intervals), pieces, groups)) {
      const auto at = [&](double along) { return is_upright ? FramePoint{i.line, along} : FramePoint{along, i.line}; };
      const bool ascends = i.high_side != is_upright;
      edges.push_back({at(ascends ? i.from : i.to), at(ascends ? i.to : i.from), i.piece});
    }
  };
  add(std::move(upright), true);
  add(std::move(flat), false);
  return edges;
}

/// Angle from the reversed direction of `in` to `out`, measured against the turn from +u towards +v. The smallest one
/// follows the region.
double turn_back(const DirectedEdge& in, const DirectedEdge& out) {
  const double back_u = in.from.u - in.to.u, back_v = in.from.v - in.to.v, u = out.to.u - out.from.u,
               v = out.to.v - out.from.v;
  const double angle = std::atan2(back_v * u - back_u * v, back_u * u + back_v * v);
  return angle > 0 ? angle : angle + 2 * std::acos(-1.0);
}

using Contour = std::vector<FramePoint>;

double area_of(const Contour& c) {
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const FramePoint p = c[i], q = c[(i + 1) % c.size()], o = c[0];
    sum += (p.u - o.u) * (q.v - o.v) - (p.v - o.v) * (q.u - o.u);
  }
  return sum / 2;
}

/// Largest distance of a point from a straight side, in lattice steps, at which it counts as on the side. It exceeds the
/// rounding of Boundary::v().
constexpr double kStraightSteps = 0x1p-10;

/// Drops points closer than half a step to their predecessor, and points on the line through their neighbours.
Contour simplified(const Contour& c, double unit) {
  const double near = unit / 2, straight = kStraightSteps * unit;
  Contour result;
  for (const FramePoint p : c) {
    if (result.empty() || std::hypot(p.u - result.back().u, p.v - result.back().v) > near) result.push_back(p);
  }
  while (result.size() > 1 && std::hypot(result.front().u - result.back().u, result.front().v - result.back().v) <= near)
    result.pop_back();
  if (result.size() < 4) return result;
  Contour corners;
  const std::size_t n = result.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FramePoint a = corners.empty() ? result[(i + n - 1) % n] : corners.back(), b = result[i], d = result[(i + 1) % n];
    const double length = std::hypot(d.u - a.u, d.v - a.v);
    const double cross = (d.u - a.u) * (b.v - a.v) - (d.v - a.v) * (b.u - a.u);
    const double along = (d.u - b.u) * (b.u - a.u) + (d.v - b.v) * (b.v - a.v);
    if (std::abs(cross) <= straight * length && along > 0) continue;
    corners.push_back(b);
  }
  return corners.size() < 3 ? result : corners;
}

/// The contours of the edges [begin, end) of one region. The edges are sorted by their first points.
std::vector<Contour> trace(const std::vector<DirectedEdge>& edges, std::size_t begin, std::size_t end) {
  std::vector<Contour> contours;
  std::vector<std::uint8_t> used(end - begin, 0);
  const auto less = [](const DirectedEdge& e, FramePoint p) { return std::tie(e.from.u, e.from.v) < std::tie(p.u, p.v); };
  const auto first_edge = edges.begin() + static_cast<std::ptrdiff_t>(begin),
             last_edge = edges.begin() + static_cast<std::ptrdiff_t>(end);
  for (std::size_t start = begin; start < end; ++start) {
    if (used[start - begin]) continue;
    Contour contour;
    std::size_t e = start;
    while (!used[e - begin]) {
      used[e - begin] = 1;
      contour.push_back(edges[e].from);
      // Continues with the edge that turns most towards the region.
      std::size_t next = e;
      double best = 0;
      for (auto o = std::lower_bound(first_edge, last_edge, edges[e].to, less); o != last_edge && o->from == edges[e].to;
           ++o) {
        const auto k = static_cast<std::size_t>(o - edges.begin());
        if (used[k - begin] && k != start) continue;
        const double angle = turn_back(edges[e], *o);
        if (next != e && angle >= best) continue;
        best = angle;
        next = k;
      }
      e = next;
    }
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace

std::vector<Region> make_regions(const std::vector<AreaPiece>& pieces, const WindowFrame& frame, const Lattice& lattice,
                                 double least_steps) {
  DisjointSets groups(pieces.size());
  std::vector<DirectedEdge> edges = contour_edges(pieces, groups);
  for (DirectedEdge& e : edges) e.piece = groups.find(e.piece);
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.piece, a.from.u, a.from.v, a.to.u, a.to.v) < std::tie(b.piece, b.from.u, b.from.v, b.to.u, b.to.v);
  });
  const double unit = frame.unit(), least = least_steps * unit;
  std::vector<Region> regions;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].piece == edges[i].piece) ++end;
    std::vector<Contour> contours = trace(edges, i, end);
    double total = 0;
    std::vector<std::pair<double, Contour>> kept;
    for (const Contour& c : contours) {
      const double area = area_of(c);
      total += area;
      Contour corners = simplified(c, unit);
      if (corners.size() >= 3 && std::abs(area) > least * least) kept.emplace_back(area, std::move(corners));
    }
    // The outer contour has the largest area. Only it has positive orientation, except for slivers that rounding leaves
    // where it touches itself.
    std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (total > least * least && !kept.empty()) {
      Region region;
      region.face = pieces[edges[i].piece].face;
      for (const auto& [area, contour] : kept) {
        if (!region.contours.empty() && area > 0) continue;
        std::vector<Point2> points;
        for (const FramePoint p : contour) points.push_back(lattice.origin_mm + frame.to_page(p.u, p.v) * lattice.step_mm);
        region.contours.push_back(std::move(points));
      }
      regions.push_back(std::move(region));
    }
    i = end;
  }
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.face < b.face; });
  return regions;
}

}  // namespace ligne::warnock
