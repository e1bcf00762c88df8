#include "visibility/appel/intersections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include <oneapi/tbb/parallel_for.h>

#include "visibility/tolerances.hpp"

// Per leaf all pairs of facets that may meet in depth and on the page are tested by the sides of their corners: above or
// below the other's plane, or on it within the touching tolerance. "On" counts as above, so that a segment through a common
// corner of two facets is found once. Pairs that pass are put together over all leaves, and only then cut.

namespace ligne::appel {
namespace {

/// Roundings of a height over a plane: a dozen operations on products of a determinant and a depth.
constexpr double kHeightRounding = 0x1p-49;

struct Corners {
  std::array<ProjectedVertex, 3> p;
  double area;
};

Corners corners_of(const Facet& f, const ProjectedVertex* vertices) {
  Corners c{{vertices[f.v[0]], vertices[f.v[1]], vertices[f.v[2]]}, 0};
  c.area = orientation(c.p[0].p, c.p[1].p, c.p[2].p);
  return c;
}

/// Heights of the other's corners over the plane of `plane` (positive: farther from the viewer), times its area; those
/// within the touching tolerance are zero. `touch` is owed half to the corners of the facet and half to the point that is held against
/// them, for a point over the facet. Outside of it the plane is extrapolated: its depth is the sum of the corners' depths with weights
/// w_i / area, some of them negative, so the errors of the corners count with |w_i| / area.
struct Heights {
  std::array<double, 3> h;
  int above = 0, below = 0, on = 0;
};

Heights heights_over(const Corners& plane, float touch, const Corners& other) {
  Heights r;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint q = other.p[i].p;
    const double w2 = orientation(plane.p[0].p, plane.p[1].p, q);
    const double w0 = orientation(plane.p[1].p, plane.p[2].p, q);
    const double w1 = orientation(plane.p[2].p, plane.p[0].p, q);
    const double a = w0 * plane.p[0].z, b = w1 * plane.p[1].z, c = w2 * plane.p[2].z, z = plane.area * other.p[i].z;
    const double h = z - (a + b + c);
    const double weights = std::abs(w0) + std::abs(w1) + std::abs(w2);  // the area, when q lies over the facet
    const double tolerance = 0.5 * touch * (weights + plane.area) + kHeightRounding * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(z));
    if (std::abs(h) <= tolerance) {
      r.h[i] = 0;
      ++r.on;
    } else {
      r.h[i] = h;
      ++(h > 0 ? r.above : r.below);
    }
  }
  return r;
}

struct PagePoint {
  double x, y, z;
};

/// Where the boundary of `c`, whose corners have heights h over a plane, passes from "on or above" to "below".
std::array<PagePoint, 2> crossings(const Corners& c, const Heights& heights) {
  std::array<PagePoint, 2> points{};
  int n = 0;
  for (int i = 0; i < 3 && n < 2; ++i) {
    const int k = (i + 1) % 3;
    const double hi = heights.h[i], hk = heights.h[k];
    if ((hi >= 0) == (hk >= 0)) continue;
    const double t = hi / (hi - hk);
    const ProjectedVertex &a = c.p[i], &b = c.p[k];
    points[n++] = {a.p.x + t * (double(b.p.x) - a.p.x), a.p.y + t * (double(b.p.y) - a.p.y), a.z + t * (b.z - a.z)};
  }
  return points;
}

/// The part of the segment over a convex region given by E_i >= 0, E linear: parameters, or nothing.
template <int N>
std::optional<std::array<double, 2>> clip(const std::array<double, N>& e0, const std::array<double, N>& e1) {
  double from = 0, to = 1;
  for (int i = 0; i < N; ++i) {
    if (e0[i] < 0 && e1[i] < 0) return std::nullopt;
    if (e0[i] < 0) from = std::max(from, e0[i] / (e0[i] - e1[i]));
    if (e1[i] < 0) to = std::min(to, e0[i] / (e0[i] - e1[i]));
  }
  if (!(from < to)) return std::nullopt;
  return std::array<double, 2>{from, to};
}

struct Segment {
  PagePoint from, to;
};

PagePoint along(const Segment& s, double t) {
  return {s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y), s.from.z + t * (s.to.z - s.from.z)};
}

/// The part of the segment that lies over the facet on the page.
std::optional<Segment> clip_to_facet(const Segment& s, const Corners& facet) {
  std::array<double, 3> e0{}, e1{};
  for (int i = 0; i < 3; ++i) {
    const LatticePoint a = facet.p[i].p, b = facet.p[(i + 1) % 3].p;
    const double sx = double(b.x) - a.x, sy = double(b.y) - a.y;
    e0[i] = sx * (s.from.y - a.y) - sy * (s.from.x - a.x);
    e1[i] = sx * (s.to.y - a.y) - sy * (s.to.x - a.x);
  }
  const auto part = clip<3>(e0, e1);
  if (!part) return std::nullopt;
  return Segment{along(s, (*part)[0]), along(s, (*part)[1])};
}

bool seen_in(const Segment& s, const CellSquare& square, double margin, float cover) {
  const double x0 = square.x - margin, x1 = square.x + square.size + margin;
  const double y0 = square.y - margin, y1 = square.y + square.size + margin;
  const auto part = clip<4>({s.from.x - x0, x1 - s.from.x, s.from.y - y0, y1 - s.from.y},
                            {s.to.x - x0, x1 - s.to.x, s.to.y - y0, y1 - s.to.y});
  if (!part) return false;
  return !(along(s, (*part)[0]).z > cover && along(s, (*part)[1]).z > cover);
}

std::optional<Segment> common_segment(const Corners& a, const Corners& b, const Heights& b_over_a) {
  const auto ends = crossings(b, b_over_a);
  return clip_to_facet({ends[0], ends[1]}, a);
}

/// A side of facet `side_of` that lies in the plane of facet `plane`, its third corner above or below.
struct SideInPlane {
  std::uint32_t plane, v0, v1, side_of;
  bool above;
  auto key() const { return std::tie(plane, v0, v1); }
};

/// A side of facet `side_of` that lies on a side of facet `plane`, and in its plane: the common line of two faces runs where one of
/// them, or both, were cut into triangles.
struct SideOnSide {
  std::uint32_t face, p0, p1;  ///< face of the plane, and its side
  std::uint32_t v0, v1;        ///< the side that lies on it
  bool above;                  ///< the third corner of `side_of` is above the plane
  std::uint32_t plane, side_of;
  auto side() const { return std::tie(face, p0, p1); }
  auto key() const { return std::tie(face, p0, p1, v0, v1); }
};

struct Pair {
  std::uint32_t a, b;  ///< facets: the plane, and the one whose boundary is cut by it
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// What one task works with.
class LeafSearch {
 public:
  LeafSearch(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, double margin)
      : scene_(scene), facets_(facets), grid_(grid), margin_(margin) {}

  void search(const Cell& cell, const CellSquare& square) {
    if (cell.count < 2) return;
    load(cell);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& a = items_[i];
      for (std::size_t k = i + 1; k < items_.size(); ++k) {
        const Item& b = items_[k];
        if (b.z_near > a.z_far) break;  // items are ordered by z_near
        if (!a.box.meets(b.box) || a.face == b.face) continue;
        test(a, b, cell, square);
      }
    }
  }
  std::vector<Pair> pairs;
  std::vector<SideInPlane> sides;
  std::vector<SideOnSide> sides_on_sides;

 private:
  struct Item {
    std::uint32_t id, face;
    std::array<std::uint32_t, 3> v;
    float z_near, z_far, touch;
    CellBox box;
    std::array<LatticePoint, 3> p;
  };

  void load(const Cell& cell) {
    items_.clear();
    const CellFacet* list = grid_.list(cell);
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      const Facet& f = facets_[list[i].facet];
      const ProjectedVertex* v = scene_.vertices.data();
      items_.push_back({list[i].facet, f.face, {f.v[0], f.v[1], f.v[2]}, list[i].z_near, f.z_far, f.touch, list[i].box,
                        {v[f.v[0]].p, v[f.v[1]].p, v[f.v[2]].p}});
    }
  }

  static int common_corners(const Item& a, const Item& b) {
    int n = 0;
    for (const std::uint32_t v : a.v) n += v == b.v[0] || v == b.v[1] || v == b.v[2];
    return n;
  }

  /// Whether a side of `a` has all of `b` on its outer side or along it: the projections have no common inside.
  static bool apart(const Item& a, const Item& b) {
    for (int i = 0; i < 3; ++i) {
      const LatticePoint s = a.p[i], e = a.p[(i + 1) % 3];
      if (orientation(s, e, b.p[0]) <= 0 && orientation(s, e, b.p[1]) <= 0 && orientation(s, e, b.p[2]) <= 0) return true;
    }
    return false;
  }

  void test(const Item& a, const Item& b, const Cell& cell, const CellSquare& square) {
    if (common_corners(a, b) > 1 || apart(a, b) || apart(b, a)) return;
    const Corners ca = corners_of(facets_[a.id], scene_.vertices.data());
    const Corners cb = corners_of(facets_[b.id], scene_.vertices.data());
    const Heights b_over_a = heights_over(ca, a.touch, cb);
    if (b_over_a.on + b_over_a.above == 3 && b_over_a.on < 2) return;
    if (b_over_a.on + b_over_a.below == 3 && b_over_a.on < 2) return;
    const Heights a_over_b = heights_over(cb, b.touch, ca);
    const bool b_along = b_over_a.on == 2, a_along = a_over_b.on == 2;
    if (b_along && a_along) {
      add_side_on_side(a, a_over_b, b, b_over_a);
      add_side_on_side(b, b_over_a, a, a_over_b);
      return;
    }
    if (b_along || a_along) {
      if (b_along && a_over_b.on < 2) add_side(a, b, b_over_a);
      if (a_along && b_over_a.on < 2) add_side(b, a, a_over_b);
      return;
    }
    if (b_over_a.on == 3 || a_over_b.on == 3) return;  // coplanar: they touch
    if (a_over_b.above + a_over_b.on == 3 || a_over_b.below + a_over_b.on == 3) return;
    const bool swapped = a.id > b.id;
    const auto segment = swapped ? common_segment(cb, ca, a_over_b) : common_segment(ca, cb, b_over_a);
    if (!segment || !(grid_.complete() || seen_in(*segment, square, margin_, cell.cover))) return;
    pairs.push_back(swapped ? Pair{b.id, a.id} : Pair{a.id, b.id});
  }

  void add_side(const Item& plane, const Item& other, const Heights& heights) {
    int off = 0;
    while (heights.h[off] == 0) ++off;
    const std::uint32_t p = other.v[(off + 1) % 3], q = other.v[(off + 2) % 3];
    sides.push_back({plane.id, std::min(p, q), std::max(p, q), other.id, heights.h[off] > 0});
  }

  /// `plane_heights` are those of the plane's corners over the other's plane, `heights` the reverse.
  void add_side_on_side(const Item& plane, const Heights& plane_heights, const Item& other, const Heights& heights) {
    int off_plane = 0, off = 0;
    while (plane_heights.h[off_plane] == 0) ++off_plane;
    while (heights.h[off] == 0) ++off;
    const std::uint32_t p = plane.v[(off_plane + 1) % 3], q = plane.v[(off_plane + 2) % 3];
    const std::uint32_t v = other.v[(off + 1) % 3], w = other.v[(off + 2) % 3];
    sides_on_sides.push_back({plane.face, std::min(p, q), std::max(p, q), std::min(v, w), std::max(v, w), heights.h[off] > 0,
                              plane.id, other.id});
  }

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  double margin_;
  std::vector<Item> items_;
};

/// A side on a side is a penetration when the face of the plane goes on behind its side, which is but a cut of its triangulation, and on the
/// other side one facet is above it and another below: the lower one is cut. (Folds that touch along edges do not penetrate.)
void match_sides_on_sides(std::vector<SideOnSide>& sides, const std::vector<Facet>& facets, std::vector<Pair>& pairs) {
  if (sides.empty()) return;
  std::sort(sides.begin(), sides.end(), [](const SideOnSide& a, const SideOnSide& b) {
    return std::tie(a.face, a.p0, a.p1, a.v0, a.v1, a.above, a.plane, a.side_of) <
           std::tie(b.face, b.p0, b.p1, b.v0, b.v1, b.above, b.plane, b.side_of);
  });
  // Facets on each of the sides, counted where the side first stands in the list.
  std::vector<std::uint8_t> facets_on(sides.size(), 0);
  for (const Facet& f : facets) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t p = std::min(f.v[k], f.v[(k + 1) % 3]), q = std::max(f.v[k], f.v[(k + 1) % 3]);
      const auto found = std::lower_bound(sides.begin(), sides.end(), std::tie(f.face, p, q),
                                          [](const SideOnSide& s, const auto& key) { return s.side() < key; });
      if (found != sides.end() && found->side() == std::tie(f.face, p, q)) ++facets_on[static_cast<std::size_t>(found - sides.begin())];
    }
  }
  std::size_t first_of_side = 0;
  for (std::size_t i = 0; i < sides.size();) {
    if (sides[i].side() != sides[first_of_side].side()) first_of_side = i;
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key() == sides[i].key()) ++end;
    if (!sides[i].above && sides[end - 1].above && facets_on[first_of_side] > 1) pairs.push_back({sides[i].plane, sides[i].side_of});
    i = end;
  }
}

/// A side in a plane is a penetration when one facet on it is above the plane and another below; the lower one is cut, whose
/// side counts as above.
void match_sides(std::vector<SideInPlane>& sides, std::vector<Pair>& pairs) {
  std::sort(sides.begin(), sides.end(), [](const SideInPlane& a, const SideInPlane& b) {
    return std::tie(a.plane, a.v0, a.v1, a.above, a.side_of) < std::tie(b.plane, b.v0, b.v1, b.above, b.side_of);
  });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key() == sides[i].key()) ++end;
    if (!sides[i].above && sides[end - 1].above) pairs.push_back({sides[i].plane, sides[i].side_of});
    i = end;
  }
}

std::vector<Pair> find_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                             double margin) {
  constexpr std::size_t kCellsPerTask = 256;
  const std::size_t n = grid.top_cell_count(), tasks = (n + kCellsPerTask - 1) / kCellsPerTask;
  std::vector<std::vector<Pair>> found(tasks);
  std::vector<std::vector<SideInPlane>> found_sides(tasks);
  std::vector<std::vector<SideOnSide>> found_sides_on_sides(tasks);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    LeafSearch search(scene, facets, grid, margin);
    for (std::size_t i = task * kCellsPerTask; i < std::min(n, (task + 1) * kCellsPerTask); ++i) {
      grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare& square) { search.search(cell, square); });
    }
    found[task] = std::move(search.pairs);
    found_sides[task] = std::move(search.sides);
    found_sides_on_sides[task] = std::move(search.sides_on_sides);
  });
  std::vector<Pair> pairs;
  std::vector<SideInPlane> sides;
  std::vector<SideOnSide> sides_on_sides;
  for (const auto& f : found) pairs.insert(pairs.end(), f.begin(), f.end());
  for (const auto& f : found_sides) sides.insert(sides.end(), f.begin(), f.end());
  for (const auto& f : found_sides_on_sides) sides_on_sides.insert(sides_on_sides.end(), f.begin(), f.end());
  match_sides(sides, pairs);
  match_sides_on_sides(sides_on_sides, facets, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

ProjectedVertex rounded(const PagePoint& p) {
  return {{static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))}, p.z};
}

/// Drops segments no longer than `least` steps, which rounding leaves where surfaces touch, unless longer ones go on at both ends: a line of
/// many facets may have short pieces, and is to be one line.
void drop_specks(std::vector<Intersection>& segments, double least) {
  const auto is_short = [least](const Intersection& s) {
    return std::hypot(double(s.to.p.x) - s.from.p.x, double(s.to.p.y) - s.from.p.y) <= least;
  };
  if (std::none_of(segments.begin(), segments.end(), is_short)) return;
  const auto less = [](const LatticePoint& a, const LatticePoint& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); };
  std::vector<LatticePoint> ends;
  for (const Intersection& s : segments) {
    if (!is_short(s)) ends.insert(ends.end(), {s.from.p, s.to.p});
  }
  std::sort(ends.begin(), ends.end(), less);
  const auto goes_on = [&](const LatticePoint& p) { return std::binary_search(ends.begin(), ends.end(), p, less); };
  std::erase_if(segments, [&](const Intersection& s) { return is_short(s) && !(goes_on(s.from.p) && goes_on(s.to.p)); });
}

}  // namespace

std::vector<Intersection> find_intersections(const ProjectedScene& scene, const std::vector<Facet>& facets,
                                             const CellGrid& grid, double margin_steps) {
  const std::vector<Pair> pairs = find_pairs(scene, facets, grid, margin_steps);
  std::vector<Intersection> result;
  result.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    const Facet &fa = facets[pair.a], &fb = facets[pair.b];
    const Corners a = corners_of(fa, scene.vertices.data()), b = corners_of(fb, scene.vertices.data());
    const auto segment = common_segment(a, b, heights_over(a, fa.touch, b));
    if (!segment) continue;
    const Intersection i{rounded(segment->from), rounded(segment->to), std::min(fa.face, fb.face),
                         std::max(fa.face, fb.face)};
    if (!(i.from.p == i.to.p)) result.push_back(i);
  }
  drop_specks(result, kLeastPartMm / scene.lattice.step_mm);
  return result;
}

}  // namespace ligne::appel
