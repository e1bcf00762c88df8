#include "visibility/warnock/understanding.hpp"

#include <algorithm>
#include <array>

namespace ligne::warnock {
namespace {

// Tuned parameters.
constexpr std::size_t kMostSeen = 12;    ///< most visible intersectors of an understood window
constexpr std::size_t kMostFacets = 16;  ///< most facets of an intersector that is compared with another on the page

/// Calls visit(p, q) for the sides of the face that meet the inner window until it returns false; returns false if it did.
template <class Visit>
bool all_sides(const Situation& s, const Placed& placed, Visit visit) {
  for (const Side& side : s.table.sides_of(*placed.face)) {
    const FramePoint p = s.table.at(side.v0), q = s.table.at(side.v1);
    if (s.inner.meets(p, q) && !visit(p, q)) return false;
  }
  return true;
}

/// True if the other triangle lies outside one side of this triangle, or along it.
bool side_separates(const FramePoint (&t)[3], const FramePoint (&o)[3]) {
  for (int i = 0; i < 3; ++i) {
    const FramePoint p = t[i], q = t[(i + 1) % 3];
    if (turn(p, q, o[0]) <= 0 && turn(p, q, o[1]) <= 0 && turn(p, q, o[2]) <= 0) return true;
  }
  return false;
}

bool facets_apart(const FaceTable& table, const Facet& a, const Facet& b) {
  const FramePoint ta[3] = {table.at(a.v[0]), table.at(a.v[1]), table.at(a.v[2])};
  const FramePoint tb[3] = {table.at(b.v[0]), table.at(b.v[1]), table.at(b.v[2])};
  return side_separates(ta, tb) || side_separates(tb, ta);
}

bool faces_apart(const Situation& s, const Face& a, const Face& b) {
  if (!a.box.meets(b.box)) return true;
  const auto of_a = s.table.facets_of(a), of_b = s.table.facets_of(b);
  if (of_a.size() > kMostFacets || of_b.size() > kMostFacets) return false;
  return std::all_of(of_a.begin(), of_a.end(), [&](std::uint32_t i) {
    return std::all_of(of_b.begin(), of_b.end(),
                       [&](std::uint32_t k) { return facets_apart(s.table, (*s.table.facets)[i], (*s.table.facets)[k]); });
  });
}

/// Smallest and largest depth difference of two planes over the added points.
class Gap {
 public:
  Gap(const Face& face, const Face& cover, DepthCounts& counts)
      : face_(face), cover_(cover), tolerance_(std::max(face.slack, cover.slack)), counts_(counts) {}

  void add(double u, double v) {
    counts_.depths += 2;
    const double h = face_.z(u, v) - cover_.z(u, v);
    lowest_ = std::min(lowest_, h);
    highest_ = std::max(highest_, h);
  }

  void add_corners(const Window& w) {
    add(w.u0, w.v0);
    add(w.u1, w.v0);
    add(w.u0, w.v1);
    add(w.u1, w.v1);
  }

  void add_corners(const ConvexWindow& w) {
    for (std::size_t i = 0; i < w.size(); ++i) add(w.corner(i).u, w.corner(i).v);
  }

  DepthComparison result() const {
    if (lowest_ > highest_) return {};
    const bool behind = highest_ > tolerance_, before = lowest_ < -tolerance_;
    const DepthOrder order = behind && before ? DepthOrder::crossing
                             : behind         ? DepthOrder::second
                             : before         ? DepthOrder::first
                                              : DepthOrder::level;
    return {order, lowest_ > tolerance_ || highest_ < -tolerance_};
  }

 private:
  const Face& face_;
  const Face& cover_;
  double tolerance_;
  DepthCounts& counts_;
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;
};

/// A triangle clipped by a rectangle; it has at most seven corners.
struct Clipped {
  std::array<FramePoint, 8> p{};
  int n = 0;
  void push(FramePoint corner) { p[n++] = corner; }
};

/// A triangle clipped by a convex window.
struct ClippedByPolygon {
  std::vector<FramePoint> p;
  int n = 0;
  void push(FramePoint corner) {
    p.push_back(corner);
    ++n;
  }
};

/// Sutherland and Hodgman: removes the part where f < 0.
template <class Polygon, class F>
Polygon cut(const Polygon& polygon, F f) {
  Polygon result;
  for (int i = 0; i < polygon.n; ++i) {
    const FramePoint a = polygon.p[i], b = polygon.p[(i + 1) % polygon.n];
    const double fa = f(a), fb = f(b);
    if (fa >= 0) result.push(a);
    if ((fa < 0) != (fb < 0)) {
      const double t = fa / (fa - fb);
      result.push({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
    }
  }
  return result;
}

Clipped clipped(const FaceTable& table, const Facet& facet, const Window& w) {
  Clipped c;
  for (const std::uint32_t v : facet.v) c.push(table.at(v));
  c = cut(c, [&](FramePoint p) { return p.u - w.u0; });
  c = cut(c, [&](FramePoint p) { return w.u1 - p.u; });
  c = cut(c, [&](FramePoint p) { return p.v - w.v0; });
  return cut(c, [&](FramePoint p) { return w.v1 - p.v; });
}

ClippedByPolygon clipped(const FaceTable& table, const Facet& facet, const ConvexWindow& w) {
  ClippedByPolygon c;
  for (const std::uint32_t v : facet.v) c.push(table.at(v));
  for (std::size_t i = 0; i < w.size() && c.n > 0; ++i) c = cut(c, [&](FramePoint p) { return w.border(i).distance(p); });
  return c;
}

/// Adds the corners of what the face has of the window.
template <class AnyWindow>
void add_clipped(const FaceTable& table, const Face& face, const AnyWindow& window, Gap& gap) {
  for (const std::uint32_t id : table.facets_of(face)) {
    const auto c = clipped(table, (*table.facets)[id], window);
    for (int i = 0; i < c.n; ++i) gap.add(c.p[i].u, c.p[i].v);
  }
}

}  // namespace

Situation::Situation(const FaceTable& t, const Lists& lists, const WindowShape& w, std::size_t most,
                     AnalysisCounts& analysis, DepthCounts& d)
    : table(t), inner(w), depth(d) {
  if (inner.empty() || lists.elements.size() > most) {
    crowded = true;
    return;
  }
  placed.reserve(lists.elements.size());
  for (const Element& e : lists.elements) {
    Placed p{e, &table.faces[e.face]};
    if (e.relation == Relation::intersector && (inner.polygon || !e.box.inside(inner.box))) {
      p.element.relation = inner.polygon ? relation_to(table, *p.face, *inner.polygon, 0, p.element.side, analysis)
                                         : relation_to(table, *p.face, inner.box, p.element.side, analysis);
      if (p.element.relation == Relation::disjoint) continue;
    }
    placed.push_back(p);
  }
}

Covers study_surrounders(const Situation& s) {
  Covers covers;
  for (const Placed& p : s.placed) {
    if (p.element.relation != Relation::surrounder) continue;
    if (!covers.front) {
      covers.front = &p;
      continue;
    }
    const DepthOrder to_front = s.compare(p, *covers.front).order;
    if (to_front == DepthOrder::second || to_front == DepthOrder::level) continue;
    if (!covers.other) {
      (to_front == DepthOrder::first ? covers.front : covers.other) = &p;
      continue;
    }
    const DepthOrder to_other = s.compare(p, *covers.other).order;
    if (to_other == DepthOrder::second || to_other == DepthOrder::level) continue;
    if (to_front == DepthOrder::first && to_other == DepthOrder::first) {
      covers = {&p, nullptr, false};
    } else {
      return {nullptr, nullptr, true};
    }
  }
  return covers;
}

std::optional<std::vector<const Placed*>> seen_intersectors(const Situation& s, const Placed* cover) {
  std::vector<const Placed*> seen;
  for (const Placed& p : s.placed) {
    if (p.element.relation != Relation::intersector) continue;
    if (cover) {
      const DepthOrder order = s.compare(p, *cover).order;
      if (order == DepthOrder::crossing) return std::nullopt;
      if (order == DepthOrder::second || order == DepthOrder::apart) continue;
    }
    seen.push_back(&p);
    if (seen.size() > kMostSeen) return std::nullopt;
  }
  return seen;
}

bool surrounder_before_everything(const Situation& s, const Covers& covers) {
  if (!covers.front || covers.other) return false;
  return std::all_of(s.placed.begin(), s.placed.end(), [&](const Placed& p) {
    if (&p == covers.front) return true;
    const DepthComparison c = s.compare(p, *covers.front);
    return c.order == DepthOrder::apart || (c.order == DepthOrder::second && c.clear);
  });
}

bool penetrating_surrounders_before_everything(const Situation& s, const Covers& covers) {
  if (!covers.front || !covers.other) return false;
  return std::all_of(s.placed.begin(), s.placed.end(), [&](const Placed& p) {
    if (&p == covers.front || &p == covers.other) return true;
    const auto hidden_by = [&](const Placed& cover) {
      const DepthComparison c = s.compare(p, cover);
      return c.order == DepthOrder::apart || (c.order == DepthOrder::second && c.clear);
    };
    return hidden_by(*covers.front) || hidden_by(*covers.other);
  });
}

bool seen_edges_in_one_line(const Situation& s, std::span<const Placed* const> seen) {
  bool first = true;
  FramePoint from, to;
  // Bit 1: the face lies to the left of the line; bit 2: to the right.
  std::vector<int> sides(seen.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool in_line = all_sides(s, *seen[i], [&](FramePoint p, FramePoint q) {
      if (first) {
        first = false;
        from = p;
        to = q;
      }
      if (turn(from, to, p) != 0 || turn(from, to, q) != 0) return false;
      sides[i] |= (q.u - p.u) * (to.u - from.u) + (q.v - p.v) * (to.v - from.v) > 0 ? 1 : 2;
      return true;
    });
    if (!in_line) return false;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t k = i + 1; k < seen.size(); ++k) {
      if ((sides[i] & sides[k]) != 0 && s.compare(*seen[i], *seen[k]).order == DepthOrder::crossing) return false;
    }
  }
  return true;
}

bool single_intersector(std::span<const Placed* const> seen) { return seen.size() == 1; }

bool seen_edges_meet_in_one_vertex(const Situation& s, std::span<const Placed* const> seen) {
  bool first = true;
  FramePoint a, b;  // candidates: both ends of the first side, while they remain possible
  bool a_serves = false, b_serves = false;
  for (const Placed* p : seen) {
    const bool together = all_sides(s, *p, [&](FramePoint from, FramePoint to) {
      if (first) {
        first = false;
        a = from;
        b = to;
        a_serves = s.inner.holds(a);
        b_serves = s.inner.holds(b);
      } else {
        a_serves = a_serves && (from == a || to == a);
        b_serves = b_serves && (from == b || to == b);
      }
      return a_serves || b_serves;
    });
    if (!together) return false;
  }
  return !first;
}

bool seen_intersectors_apart(const Situation& s, std::span<const Placed* const> seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t k = i + 1; k < seen.size(); ++k) {
      if (!faces_apart(s, *seen[i]->face, *seen[k]->face)) return false;
    }
  }
  return true;
}

Understood understand(const Situation& s, Knowledge knowledge) {
  if (s.crowded || knowledge == Knowledge::nothing) return Understood::no;
  const bool four = knowledge >= Knowledge::four_cases, all = knowledge == Knowledge::all;
  const Covers covers = study_surrounders(s);
  if (covers.failed) return Understood::no;
  if (surrounder_before_everything(s, covers)) return Understood::surrounder;
  if (covers.other) {
    if (four && penetrating_surrounders_before_everything(s, covers)) return Understood::penetrating_surrounders;
    return Understood::no;
  }
  const auto seen = seen_intersectors(s, covers.front);
  if (!seen) return Understood::no;
  if (single_intersector(*seen)) return Understood::single_intersector;
  if (four && seen_edges_in_one_line(s, *seen)) return Understood::one_line;
  if (all && seen_edges_meet_in_one_vertex(s, *seen)) return Understood::one_vertex;
  if (all && seen_intersectors_apart(s, *seen)) return Understood::apart;
  return Understood::no;
}

DepthComparison compare_depth(const FaceTable& table, const Element& element, const Face& cover, const WindowShape& window,
                              DepthCounts& counts) {
  ++counts.comparisons;
  const Face& face = table.faces[element.face];
  Gap rough(face, cover, counts);
  if (element.relation == Relation::surrounder) {
    if (window.polygon) {
      rough.add_corners(*window.polygon);
    } else {
      rough.add_corners(window.box);
    }
    return rough.result();
  }
  const Window common = window.box.common(face.box);
  if (common.empty()) return {};
  rough.add_corners(common);
  const DepthComparison result = rough.result();
  if (result.clear || result.order == DepthOrder::level) return result;
  ++counts.clipped;
  Gap exact(face, cover, counts);
  if (window.polygon) {
    add_clipped(table, face, *window.polygon, exact);
  } else {
    add_clipped(table, face, common, exact);
  }
  return exact.result();
}

}  // namespace ligne::warnock
