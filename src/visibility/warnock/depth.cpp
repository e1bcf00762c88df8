#include "visibility/warnock/depth.hpp"

#include <algorithm>
#include <array>

namespace ligne::warnock {
namespace {

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
