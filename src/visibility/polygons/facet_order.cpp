#include "visibility/polygons/facet_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ligne {
namespace {

struct Corner {
  LatticePoint p;
  double z;
};
using Corners = std::array<Corner, 3>;

Corners corners_of(const Facet& f, const std::vector<ProjectedVertex>& vertices) {
  const ProjectedVertex &a = vertices[f.v[0]], &b = vertices[f.v[1]], &c = vertices[f.v[2]];
  return {Corner{a.p, a.z}, Corner{b.p, b.z}, Corner{c.p, c.z}};
}

/// Whether a side of `a` has all of `b` on its outer side or along it. Exact.
bool apart(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const LatticePoint s = a[i].p, e = a[(i + 1) % 3].p;
    if (orientation(s, e, b[0].p) <= 0 && orientation(s, e, b[1].p) <= 0 && orientation(s, e, b[2].p) <= 0) return true;
  }
  return false;
}

struct Place {
  double x, y;
  double d;  ///< depth of the first facet minus that of the second
};

/// Depth over a facet, from weights that are determinants: as accurate for slivers as for other facets.
class FacetPlane {
 public:
  explicit FacetPlane(const Corners& c) : c_(c), area_(orientation(c[0].p, c[1].p, c[2].p)) {}

  double weight(std::size_t side, double x, double y) const {
    const LatticePoint a = c_[side].p, b = c_[(side + 1) % 3].p;
    return (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
  }
  double z(double x, double y) const {
    return (weight(1, x, y) * c_[0].z + weight(2, x, y) * c_[1].z + weight(0, x, y) * c_[2].z) / area_;
  }

 private:
  const Corners& c_;
  double area_;
};

/// Corners of the overlap, at most six. Double arithmetic suffices: all decisions on them have a tolerance of at least
/// one step.
struct Overlap {
  std::array<Place, 9> p;
  std::size_t n = 0;

  void clip(const FacetPlane& plane, std::size_t side) {
    std::array<Place, 9> out;
    std::size_t m = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Place &a = p[i], &b = p[i + 1 == n ? 0 : i + 1];
      const double wa = plane.weight(side, a.x, a.y), wb = plane.weight(side, b.x, b.y);
      if (wa >= 0 && m < out.size()) out[m++] = a;
      if ((wa >= 0) != (wb >= 0) && m < out.size()) {
        const double t = wa / (wa - wb);
        out[m++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0};
      }
    }
    p = out;
    n = m;
  }
};

LatticePoint rounded(const Place& p) {
  return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
}

/// Finds the common line: the two points with d = 0 on the boundary of the overlap, so directed that the first facet is
/// in front on its left.
bool find_cut(const Overlap& o, LatticeSegment& cut) {
  std::array<Place, 9> zero;
  std::size_t n = 0;
  const Place* front = &o.p[0];
  for (std::size_t i = 0; i < o.n; ++i) {
    const Place &a = o.p[i], &b = o.p[i + 1 == o.n ? 0 : i + 1];
    if (a.d < front->d) front = &a;
    if ((a.d < 0) == (b.d < 0) || n == zero.size()) continue;
    const double t = a.d / (a.d - b.d);
    zero[n++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0};
  }
  if (n < 2) return false;
  cut = {rounded(zero[0]), rounded(zero[n - 1])};
  if (cut.a == cut.b) return false;
  const double at_front = cut.dx() * (front->y - cut.a.y) - cut.dy() * (front->x - cut.a.x);
  if (at_front < 0) std::swap(cut.a, cut.b);
  return true;
}

/// `a` is the facet of the lower number.
FacetOrder ordered(const Facet& fa, const Facet& fb, const Corners& a, const Corners& b) {
  FacetOrder result;
  if (apart(a, b) || apart(b, a)) return result;
  const double touch = double(fa.depth_tolerance) + double(fb.depth_tolerance);
  if (double(fa.z_far) + touch < fb.z_near) {
    result.order = DepthOrder::first;
    return result;
  }
  if (double(fb.z_far) + touch < fa.z_near) {
    result.order = DepthOrder::second;
    return result;
  }
  const FacetPlane plane_a(a), plane_b(b);
  Overlap overlap;
  for (const Corner& c : a) overlap.p[overlap.n++] = {double(c.p.x), double(c.p.y), 0};
  for (std::size_t side = 0; side < 3; ++side) overlap.clip(plane_b, side);
  double low = 0, high = 0, least = 1e300;
  for (std::size_t i = 0; i < overlap.n; ++i) {
    Place& p = overlap.p[i];
    p.d = plane_a.z(p.x, p.y) - plane_b.z(p.x, p.y);
    low = std::min(low, p.d);
    high = std::max(high, p.d);
    least = std::min(least, std::abs(p.d));
  }
  result.touching = least <= touch;
  if (-low <= touch && high <= touch) {
    result.tie = true;
    result.order = fa.face < fb.face ? DepthOrder::first : DepthOrder::second;
  } else if (-low > touch && high > touch && find_cut(overlap, result.cut)) {
    result.order = DepthOrder::crossing;
  } else {
    result.order = high < -low ? DepthOrder::first : DepthOrder::second;
  }
  return result;
}

}  // namespace

FacetOrder order_of(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t a,
                    std::uint32_t b) {
  const Corners ca = corners_of(facets[a], vertices), cb = corners_of(facets[b], vertices);
  if (a < b) return ordered(facets[a], facets[b], ca, cb);
  FacetOrder result = ordered(facets[b], facets[a], cb, ca);
  if (result.order == DepthOrder::first) {
    result.order = DepthOrder::second;
  } else if (result.order == DepthOrder::second) {
    result.order = DepthOrder::first;
  }
  std::swap(result.cut.a, result.cut.b);
  return result;
}

}  // namespace ligne
