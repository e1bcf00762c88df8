#include "visibility/penetration/penetration.hpp"

#include <algorithm>
#include <cmath>

#include "base/index_lists.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"

namespace ligne {
namespace {

/// Relative rounding error of a height over a plane: a dozen operations on products of a determinant and a depth.
constexpr double kHeightRounding = 0x1p-49;

}  // namespace

/// Heights of the other facet's corners over the plane of `plane` (positive: farther from the viewer), times the area
/// of `plane`; heights within the depth tolerance are zero. For a point over the facet, half of `touch` allows for
/// errors of the facet's corners, and half for the error of the point. Elsewhere the plane is extrapolated: its depth
/// is the sum of the corners' depths with weights w_i / area, some of them negative, so the corners' errors count with
/// |w_i| / area.
struct PenetrationSearch::Heights {
  std::array<double, 3> h;
  int above = 0, below = 0, on = 0;

  static Heights over(const PlacedFacet& plane, const PlacedFacet& other);
};

PenetrationSearch::Heights PenetrationSearch::Heights::over(const PlacedFacet& plane, const PlacedFacet& other) {
  Heights r;
  const double area = plane.area(), half_touch = 0.5 * plane.touch;
  for (std::size_t i = 0; i < 3; ++i) {
    const double w2 = plane.side(0, other, i), w0 = plane.side(1, other, i), w1 = plane.side(2, other, i);
    const double a = w0 * plane.z[0], b = w1 * plane.z[1], c = w2 * plane.z[2], z = area * other.z[i];
    const double h = z - (a + b + c);
    const double weights =
        std::abs(w0) + std::abs(w1) + std::abs(w2);  // equal to the area if the corner lies over the facet
    const double tolerance =
        half_touch * (weights + area) + kHeightRounding * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(z));
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

namespace {

/// The two points at which the boundary of `f` passes between "on or above" a plane and "below" it; `heights`: of the
/// corners over the plane.
std::array<PagePoint, 2> crossings(const PlacedFacet& f, const std::array<double, 3>& heights) {
  std::array<PagePoint, 2> points{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3 && n < 2; ++i) {
    const std::size_t k = (i + 1) % 3;
    const double hi = heights[i], hk = heights[k];
    if ((hi >= 0) == (hk >= 0)) continue;
    const double t = hi / (hi - hk);
    points[n++] = {f.x[i] + t * (f.x[k] - f.x[i]), f.y[i] + t * (f.y[k] - f.y[i]), f.z[i] + t * (f.z[k] - f.z[i])};
  }
  return points;
}

/// The part of the segment that lies over the facet on the page.
std::optional<PageSegment> clip_to_facet(const PageSegment& s, const PlacedFacet& facet) {
  std::array<double, 3> e0{}, e1{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double ax = facet.x[i], ay = facet.y[i], sx = facet.ey[i], sy = -facet.ex[i];
    e0[i] = sx * (s.from.y - ay) - sy * (s.from.x - ax);
    e1[i] = sx * (s.to.y - ay) - sy * (s.to.x - ax);
  }
  const auto part = clip_parameters(e0, e1);
  if (!part) return std::nullopt;
  return PageSegment{s.at((*part)[0]), s.at((*part)[1])};
}

std::optional<PageSegment> common_segment(const PlacedFacet& a, const PlacedFacet& b,
                                          const std::array<double, 3>& b_over_a) {
  const auto ends = crossings(b, b_over_a);
  return clip_to_facet({ends[0], ends[1]}, a);
}

/// Whether all of `b` lies outside a side of `a` or along it: then the projections do not overlap.
bool apart(const PlacedFacet& a, const PlacedFacet& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.side(i, b, 0) <= 0 && a.side(i, b, 1) <= 0 && a.side(i, b, 2) <= 0) return true;
  }
  return false;
}

/// Drops segments no longer than `least` steps, which rounding leaves where surfaces touch. A segment with longer ones
/// at both ends stays: a line across many facets may have short pieces, and must not break.
void drop_specks(std::vector<Intersection>& segments, double least) {
  const auto is_short = [least](const Intersection& s) {
    return std::hypot(double(s.to.p.x) - s.from.p.x, double(s.to.p.y) - s.from.p.y) <= least;
  };
  if (std::none_of(segments.begin(), segments.end(), is_short)) return;
  // The ends of short segments, and whether a longer one ends there too.
  std::vector<std::pair<LatticePoint, bool>> asked;
  for (const Intersection& s : segments) {
    if (is_short(s)) asked.insert(asked.end(), {{s.from.p, false}, {s.to.p, false}});
  }
  std::sort(asked.begin(), asked.end());
  const auto at = [&](const LatticePoint& p) {
    return std::ranges::lower_bound(asked, p, {}, &std::pair<LatticePoint, bool>::first);
  };
  for (const Intersection& s : segments) {
    if (is_short(s)) continue;
    for (const LatticePoint& p : {s.from.p, s.to.p}) {
      for (auto place = at(p); place != asked.end() && place->first == p && !place->second; ++place) place->second = true;
    }
  }
  const auto continues = [&](const LatticePoint& p) { return at(p)->second; };
  std::erase_if(segments, [&](const Intersection& s) { return is_short(s) && !(continues(s.from.p) && continues(s.to.p)); });
}

}  // namespace

ProjectedVertex rounded(const PagePoint& p) {
  return {{static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))}, p.z};
}

bool CutSides::has(std::uint32_t face, std::uint32_t v, std::uint32_t w) const {
  std::call_once(found_, [this] { find(); });
  return std::binary_search(sides_.begin(), sides_.end(), Side{face, std::min(v, w), std::max(v, w)});
}

/// This thread works alone: if it waited for others, it could start work that calls has() again.
void CutSides::find() const {
  std::uint32_t faces = 0;
  for (const Facet& f : *facets_) faces = std::max(faces, f.face + 1);
  const auto by_face = numbers_by_key(faces, facets_->size(), [this](std::uint32_t i) { return (*facets_)[i].face; });
  std::vector<Side> sides;
  for (std::uint32_t face = 0; face < faces; ++face) {
    if (by_face[face].size() < 2) continue;
    sides.clear();
    for (const std::uint32_t i : by_face[face]) {
      const Facet& f = (*facets_)[i];
      for (int k = 0; k < 3; ++k)
        sides.push_back({face, std::min(f.v[k], f.v[(k + 1) % 3]), std::max(f.v[k], f.v[(k + 1) % 3])});
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i] == sides[i - 1] && (i == 1 || sides[i] != sides[i - 2])) sides_.push_back(sides[i]);
    }
  }
}

bool overlap_on_page(const PlacedFacet& a, const PlacedFacet& b) { return !apart(a, b) && !apart(b, a); }

PlacedFacet PenetrationSearch::place(std::uint32_t facet) const {
  const Facet& f = (*facets_)[facet];
  PlacedFacet placed{facet, f.face, {f.v[0], f.v[1], f.v[2]}, f.depth_tolerance, {}, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const ProjectedVertex& v = (*vertices_)[f.v[i]];
    placed.x[i] = v.p.x, placed.y[i] = v.p.y, placed.z[i] = v.z;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = i == 2 ? 0 : i + 1;
    placed.ex[i] = placed.y[i] - placed.y[k], placed.ey[i] = placed.x[k] - placed.x[i];
    placed.e[i] = -(placed.ex[i] * placed.x[i] + placed.ey[i] * placed.y[i]);
  }
  return placed;
}

std::optional<PenetrationSearch::Found> PenetrationSearch::segment_of(const PlacedFacet& a, const PlacedFacet& b) {
  // Facets that penetrate overlap on the page and have no common side: a test on the lattice, much cheaper than the rest.
  if (!overlap_on_page(a, b) || common_corners(a, b) > 1) return std::nullopt;
  const Heights b_over_a = Heights::over(a, b);
  if (b_over_a.on == 3) return std::nullopt;  // coplanar: they touch
  if (b_over_a.on + b_over_a.above == 3 && b_over_a.on < 2) return std::nullopt;
  if (b_over_a.on + b_over_a.below == 3 && b_over_a.on < 2) return std::nullopt;
  const Heights a_over_b = Heights::over(b, a);
  const bool b_along = b_over_a.on == 2, a_along = a_over_b.on == 2;
  if (b_along && a_along) {
    add_side_on_side(a, a_over_b, b, b_over_a);
    add_side_on_side(b, b_over_a, a, a_over_b);
    return std::nullopt;
  }
  if (b_along || a_along) {
    if (b_along && a_over_b.on < 2) add_side(a, b, b_over_a);
    if (a_along && b_over_a.on < 2) add_side(b, a, a_over_b);
    return std::nullopt;
  }
  if (a_over_b.on == 3) return std::nullopt;
  if (a_over_b.above + a_over_b.on == 3 || a_over_b.below + a_over_b.on == 3) return std::nullopt;
  const bool swapped = a.id > b.id;
  const auto segment = swapped ? common_segment(b, a, a_over_b.h) : common_segment(a, b, b_over_a.h);
  if (!segment) return std::nullopt;
  return Found{swapped ? Pair{b.id, a.id} : Pair{a.id, b.id}, *segment};
}

void PenetrationSearch::add_side(const PlacedFacet& plane, const PlacedFacet& other, const Heights& heights) {
  int off = 0;
  while (heights.h[off] == 0) ++off;
  const int from = (off + 1) % 3, to = (off + 2) % 3;
  // A side beyond the facet, or one that only touches it, does not count.
  std::array<double, 3> e0{}, e1{};
  for (std::size_t i = 0; i < 3; ++i) {
    e0[i] = plane.side(i, other, static_cast<std::size_t>(from));
    e1[i] = plane.side(i, other, static_cast<std::size_t>(to));
  }
  if (!clip_parameters(e0, e1)) return;
  const std::uint32_t p = other.v[from], q = other.v[to];
  sides_.push_back({plane.id, std::min(p, q), std::max(p, q), heights.h[off] > 0, other.id});
}

/// `plane_heights`: heights of the plane's corners over the other facet's plane; `heights`: the reverse.
void PenetrationSearch::add_side_on_side(const PlacedFacet& plane, const Heights& plane_heights, const PlacedFacet& other,
                                         const Heights& heights) {
  int off_plane = 0, off = 0;
  while (plane_heights.h[off_plane] == 0) ++off_plane;
  while (heights.h[off] == 0) ++off;
  const std::uint32_t p = plane.v[(off_plane + 1) % 3], q = plane.v[(off_plane + 2) % 3];
  if (!cut_sides_->has(plane.face, p, q)) return;
  const std::uint32_t v = other.v[(off + 1) % 3], w = other.v[(off + 2) % 3];
  sides_on_sides_.push_back(
      {plane.face, std::min(p, q), std::max(p, q), std::min(v, w), std::max(v, w), heights.h[off] > 0, plane.id, other.id});
}

/// A side in a plane, or on a side, is a penetration if one facet at it is above the plane and another below. The lower one
/// is cut: a side in a plane counts as above, and folds that touch along edges do not penetrate, as the face of the plane
/// ends there.
template <class Side>
void PenetrationSearch::match(std::vector<Side>& sides) {
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key() == sides[i].key()) ++end;
    if (!sides[i].above && sides[end - 1].above) pairs_.push_back({sides[i].plane, sides[i].side_of});
    i = end;
  }
}

void PenetrationSearch::forget_repeated() {
  constexpr std::size_t kDirectPairs = 10'000;
  const auto count = [&] { return pairs_.size() + sides_.size() + sides_on_sides_.size(); };
  if (count() < 2 * distinct_ + kDirectPairs) return;
  const auto keep_distinct = [](auto& found) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  };
  keep_distinct(pairs_);
  keep_distinct(sides_);
  keep_distinct(sides_on_sides_);
  distinct_ = count();
}

void PenetrationSearch::add(PenetrationSearch&& other) {
  const auto append = [](auto& all, auto& found) {
    all.insert(all.end(), found.begin(), found.end());
    found = {};
  };
  append(pairs_, other.pairs_);
  append(sides_, other.sides_);
  append(sides_on_sides_, other.sides_on_sides_);
  forget_repeated();
}

std::vector<Intersection> PenetrationSearch::finish(double least_steps) {
  match(sides_);
  match(sides_on_sides_);
  parallel_sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  std::vector<Intersection> result(pairs_.size());
  parallel_each(pairs_.size(), [&](std::size_t i) {
    const PlacedFacet a = place(pairs_[i].a), b = place(pairs_[i].b);
    const auto segment = common_segment(a, b, Heights::over(a, b).h);
    if (!segment) return;
    result[i] = {rounded(segment->from), rounded(segment->to), std::min(a.face, b.face), std::max(a.face, b.face)};
  });
  // Removes pairs without a segment, or with one seen end on.
  std::erase_if(result, [](const Intersection& i) { return i.from.p == i.to.p; });
  drop_specks(result, least_steps);
  return result;
}

}  // namespace ligne
