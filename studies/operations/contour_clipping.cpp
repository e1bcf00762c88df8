#include "studies/operations/contour_clipping.hpp"

#include <algorithm>

namespace ligne::studies {
namespace {

double side_of(Point2 a, Point2 b, Point2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }
double dot(Point2 u, Point2 v) { return u.x * v.x + u.y * v.y; }

/// Rays from an inner point of a convex contour through its corners. They bound n sectors, one per side.
class SectorFan {
 public:
  /// The inner point is the weighted mean of three corners. Different weights of the first give different points.
  SectorFan(const Contour& contour, int weight) : contour_(contour), scale_(weight + 2) {
    const std::size_t n = contour.size();
    std::size_t i = n / 3, k = 2 * n / 3;
    if (side_of(contour[0], contour[i], contour[k]) == 0) {  // three collinear corners
      i = 1;
      for (k = 2; k + 1 < n && side_of(contour[0], contour[i], contour[k]) == 0;) ++k;
    }
    centre_ = contour[0] * double(weight) + contour[i] + contour[k];
  }

  /// Vector from the inner point to p, scaled so that integer coordinates stay integers.
  Point2 ray(Point2 p) const { return p * double(scale_) - centre_; }
  Point2 corner(std::size_t i) const { return contour_[i % contour_.size()]; }
  std::size_t size() const { return contour_.size(); }

  /// Index of the sector of a direction, by binary search. The ray through a corner belongs to the side that begins there.
  std::size_t sector_of(Point2 d, ContourClipCounts& counts) const {
    const Point2 first = ray(contour_[0]);
    const auto beyond_half = [&](Point2 v) {
      const double turn = cross(first, v);
      return turn < 0 || (turn == 0 && dot(first, v) < 0);
    };
    const bool half = beyond_half(d);
    std::size_t low = 0, high = size();
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      const Point2 v = ray(contour_[middle]);
      counts.signs += 2;
      const bool passed = beyond_half(v) != half ? half : cross(v, d) >= 0;
      (passed ? low : high) = middle;
    }
    return low;
  }

 private:
  const Contour& contour_;
  int scale_;
  Point2 centre_;
};

/// A point met on the walk round the inner point of B: a corner of a chain of A, a corner of B, or a crossing.
struct Met {
  enum class Kind : std::uint8_t { of_a, of_b, crossing } kind;
  Point2 point;
  int nearer;  ///< order along the ray through the point: +1 chain nearer than B, -1 B nearer, 0 they meet
};

/// Walks a chain of A and the sides of B together. The corners of the chain are sorted by angle about the inner point of B,
/// so each ray meets one side of either. Each corner takes one sign test against the side of the other contour in its
/// sector. Two sides cross in a sector where their order changes between its ends. An open chain meets the corners of B
/// strictly between its ends, a closed one all of them.
std::vector<Met> walk(const Contour& chain, bool closed, const SectorFan& b, ContourClipCounts& counts) {
  std::vector<Met> met;
  std::size_t sector = b.sector_of(b.ray(chain.front()), counts);
  const auto sign_at = [&](Point2 from, Point2 to, Point2 p) {
    ++counts.signs;
    const double side = side_of(from, to, p);
    return (side > 0) - (side < 0);
  };
  const auto meet = [&](Met::Kind kind, Point2 point, int nearer, Point2 a_from, Point2 a_to, Point2 b_from, Point2 b_to) {
    if (!met.empty() && met.back().nearer * nearer < 0) {
      ++counts.crossings;
      const double from = side_of(b_from, b_to, a_from), to = side_of(b_from, b_to, a_to);
      met.push_back({Met::Kind::crossing, a_from + (a_to - a_from) * (from / (from - to)), 0});
    }
    met.push_back({kind, point, nearer});
  };
  meet(Met::Kind::of_a, chain.front(), sign_at(b.corner(sector), b.corner(sector + 1), chain.front()), {}, {}, {}, {});
  const std::size_t sides = closed ? chain.size() : chain.size() - 1;
  std::size_t left = b.size();
  for (std::size_t i = 0; i < sides; ++i) {
    const Point2 from = chain[i], to = chain[(i + 1) % chain.size()], end = b.ray(to);
    const bool last = i + 1 == sides;
    // The corners of B in the sector of this side of A.
    for (; left > 0; --left) {
      const Point2 b_from = b.corner(sector), b_to = b.corner(sector + 1), ray = b.ray(b_to);
      counts.signs += 2;
      const double turn = cross(ray, end);  // also zero for opposite rays, where the inner point lies on the side of A
      const bool before = (turn > 0 || (turn == 0 && dot(ray, end) < 0)) && cross(b.ray(from), ray) >= 0;
      if (!before && !(closed && last)) break;
      meet(Met::Kind::of_b, b_to, -sign_at(from, to, b_to), from, to, b_from, b_to);
      ++sector;
    }
    const Point2 b_from = b.corner(sector), b_to = b.corner(sector + 1);
    meet(Met::Kind::of_a, to, sign_at(b_from, b_to, to), from, to, b_from, b_to);
  }
  if (closed) met.pop_back();  // the first corner, repeated
  return met;
}

void add_corner(Contour& contour, Point2 p) {
  if (contour.empty() || contour.back() != p) contour.push_back(p);
}

/// Shamos, inner point of B inside A: keeps the nearer of the two contours all round.
Contour clip_round_common_point(const Contour& a, const SectorFan& b, ContourClipCounts& counts) {
  Contour out;
  for (const Met& m : walk(a, true, b, counts)) {
    const bool drawn = m.kind == Met::Kind::crossing || (m.kind == Met::Kind::of_a ? m.nearer >= 0 : m.nearer <= 0);
    if (drawn) add_corner(out, m.point);
  }
  return out;
}

/// Shamos, inner point of B outside A (figure 3.21): seen from the point, A has a far and a near chain. The intersection
/// ends at the nearer of B and the far chain, and begins at the near chain.
Contour clip_from_outside(const Contour& a, const std::vector<bool>& is_near, const SectorFan& b,
                          ContourClipCounts& counts) {
  const std::size_t n = a.size();
  std::size_t begin = 0;
  while (is_near[begin] || !is_near[(begin + n - 1) % n]) ++begin;  // the first side of the far chain
  Contour far{a[begin]}, near;
  std::size_t i = begin;
  for (; !is_near[i % n]; ++i) far.push_back(a[(i + 1) % n]);
  for (; i <= begin + n; ++i) near.push_back(a[i % n]);
  std::reverse(near.begin(), near.end());
  const std::vector<Met> by_far = walk(far, false, b, counts), by_near = walk(near, false, b, counts);
  Contour out;
  auto at_near = by_near.begin();
  for (const Met& m : by_far) {
    bool drawn = m.kind == Met::Kind::crossing || m.nearer >= 0;
    if (m.kind == Met::Kind::of_b) {
      while (at_near->kind != Met::Kind::of_b) ++at_near;
      drawn = m.nearer <= 0 && at_near->nearer >= 0;
      ++at_near;
    }
    if (drawn) add_corner(out, m.point);
  }
  for (auto m = by_near.rbegin(); m != by_near.rend(); ++m) {
    if (m->kind == Met::Kind::crossing || (m->kind == Met::Kind::of_a && m->nearer >= 0)) add_corner(out, m->point);
  }
  return out;
}

}  // namespace

Contour clip_side_by_side(const Contour& subject, const Contour& clip, ContourClipCounts& counts) {
  Contour list = subject;
  for (std::size_t i = 0; i < clip.size() && !list.empty(); ++i) {
    const Point2 a = clip[i], b = clip[(i + 1) % clip.size()];
    Contour kept;
    Point2 from = list.back();
    double of_from = side_of(a, b, from);
    ++counts.signs;
    for (const Point2 to : list) {
      const double of_to = side_of(a, b, to);
      ++counts.signs;
      if ((of_from < 0) != (of_to < 0) && of_from != 0 && of_to != 0) {
        ++counts.crossings;
        kept.push_back(from + (to - from) * (of_from / (of_from - of_to)));
      }
      if (of_to >= 0) kept.push_back(to);
      from = to;
      of_from = of_to;
    }
    list = std::move(kept);
  }
  return list;
}

Contour clip_convex(const Contour& a, const Contour& b, ContourClipCounts& counts) {
  if (a.size() < 3 || b.size() < 3) return {};
  // An inner point of B that is no corner of A. Few weights fail: A has few corners on the line through these points.
  int weight = 1;
  const auto is_corner_of_a = [&](const SectorFan& fan) {
    return std::any_of(a.begin(), a.end(), [&](Point2 p) { return fan.ray(p) == Point2{0, 0}; });
  };
  while (is_corner_of_a(SectorFan(b, weight))) ++weight;
  const SectorFan fan(b, weight);
  std::vector<bool> is_near(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ++counts.signs;
    is_near[i] = cross(fan.ray(a[i]), fan.ray(a[(i + 1) % a.size()])) < 0;
  }
  const bool inside = std::none_of(is_near.begin(), is_near.end(), [](bool near) { return near; });
  Contour common = inside ? clip_round_common_point(a, fan, counts) : clip_from_outside(a, is_near, fan, counts);
  if (common.size() > 1 && common.front() == common.back()) common.pop_back();
  return common.size() < 3 ? Contour{} : common;
}

double twice_area_of(const Contour& contour) {
  double sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point2 a = contour[i] - contour[0], b = contour[(i + 1) % contour.size()] - contour[0];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace ligne::studies
