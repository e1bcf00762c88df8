#include "studies/operations/plane_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ligne::studies {
namespace {

using Kind = PlaneCurve::Kind;

/// Coefficients of a line u x + w z = k.
struct Line {
  std::int64_t u = 0, w = 0, k = 0;
};

Line line_of(const PlaneCurve& s) {
  const std::int64_t dx = s.right - s.left, dz = s.z_right - s.z_left;
  return {-dz, dx, dx * s.z_left - dz * s.left};
}

/// The line through the common points of two circles.
Line radical_line(const PlaneCurve& a, const PlaneCurve& b) {
  const auto power = [](const PlaneCurve& c) {
    return std::int64_t{c.x_middle} * c.x_middle + std::int64_t{c.z_middle} * c.z_middle - c.radius_square;
  };
  return {2 * (std::int64_t{b.x_middle} - a.x_middle), 2 * (std::int64_t{b.z_middle} - a.z_middle), power(b) - power(a)};
}

/// True if the point of the line at x lies on the half of the circle that the arc is part of; both halves have the ends.
bool is_on_half(const PlaneCurve& arc, const Line& line, const OneRoot& x) {
  // w (z - z_middle) = k - u x - w z_middle
  const int side = x.sign_of_linear(-line.u, Int128(line.k) - Int128(line.w) * arc.z_middle) * (line.w > 0 ? 1 : -1);
  return arc.kind == Kind::far_arc ? side >= 0 : side <= 0;
}

/// Abscissas where candidates meet, kept if they lie in the common range.
class Meetings {
 public:
  Meetings(const PlaneCurve& a, const PlaneCurve& b, CurveMeeting& result)
      : begin_(std::max(a.left, b.left)), end_(std::min(a.right, b.right)), result_(result) {}

  void add(const OneRoot& x, bool crosses) {
    if (x < begin_ || end_ < x) return;
    result_.points[result_.count] = x;
    result_.crosses[result_.count++] = crosses && begin_ < x && x < end_;
  }

 private:
  OneRoot begin_, end_;
  CurveMeeting& result_;
};

/// Points of a line, not parallel to z, on an arc; with `other`, on that arc as well.
void meet_line(const PlaneCurve& arc, const PlaneCurve* other, const Line& line, Meetings& meetings) {
  // (x - cx)^2 w^2 + (k - u x - w cz)^2 = r^2 w^2, as a x^2 - 2 h x + c = 0.
  const Int128 u = line.u, w = line.w, m = line.k - w * arc.z_middle, cx = arc.x_middle;
  const Int128 a = u * u + w * w, h = w * w * cx + u * m, c = w * w * (cx * cx - arc.radius_square) + m * m;
  const Int128 root = h * h - a * c;
  if (root < 0) return;
  for (const int e : {-1, 1}) {
    const OneRoot x(h, e, root, a);
    if (is_on_half(arc, line, x) && (!other || is_on_half(*other, line, x))) meetings.add(x, root > 0);
    if (root == 0) return;
  }
}

void meet_lines(const Line& s, const Line& t, Meetings& meetings) {
  const Int128 det = Int128(s.u) * t.w - Int128(t.u) * s.w;
  if (det != 0) meetings.add(OneRoot(Int128(s.k) * t.w - Int128(t.k) * s.w, 0, 0, det), true);
}

/// Arcs of two circles with centres at the same depth, or the two halves of one circle.
void meet_level(const PlaneCurve& a, const PlaneCurve& b, const Line& line, Meetings& meetings) {
  if (line.u == 0) {
    if (line.k != 0) return;  // concentric
    for (const int e : {-1, 1}) meetings.add(OneRoot(Int128(a.x_middle), e, a.radius_square, 1), false);
    return;
  }
  const OneRoot x(Int128(line.k), 0, 0, Int128(line.u));
  // Square of half the chord, times u^2.
  const Int128 apart = line.k - Int128(line.u) * a.x_middle;
  const Int128 chord = Int128(line.u) * line.u * a.radius_square - apart * apart;
  if (chord == 0 || (chord > 0 && a.kind == b.kind)) meetings.add(x, chord > 0);
}

bool is_one_line(const Line& s, const Line& t) {
  return Int128(s.u) * t.w == Int128(t.u) * s.w && Int128(s.k) * t.w == Int128(t.k) * s.w;
}

}  // namespace

PlaneCurve PlaneCurve::segment(LatticePoint a, LatticePoint b, bool is_transparent) {
  if (b.x < a.x) std::swap(a, b);
  return {.is_transparent = is_transparent, .left = a.x, .right = b.x, .z_left = a.y, .z_right = b.y};
}

PlaneCurve PlaneCurve::arc(Kind half, LatticePoint centre, std::int32_t radius, LatticePoint range, bool is_transparent) {
  return {.kind = half,
          .is_transparent = is_transparent,
          .left = std::clamp(range.x, centre.x - radius, centre.x + radius),
          .right = std::clamp(range.y, centre.x - radius, centre.x + radius),
          .x_middle = centre.x,
          .z_middle = centre.y,
          .radius_square = radius * radius};
}

double PlaneCurve::depth(double x) const {
  if (!is_arc()) return z_left + (x - left) * (double(z_right) - z_left) / (double(right) - left);
  const double chord = std::sqrt(std::max(0.0, radius_square - (x - x_middle) * (x - x_middle)));
  return z_middle + (kind == Kind::far_arc ? chord : -chord);
}

std::array<std::int64_t, 4> carrier_of(const PlaneCurve& curve) {
  const auto kind = static_cast<std::int64_t>(curve.kind);
  if (curve.is_arc()) return {kind, curve.x_middle, curve.z_middle, curve.radius_square};
  const Line line = line_of(curve);
  const std::int64_t d = std::gcd(std::gcd(line.u, line.w), line.k);
  return {kind, line.u / d, line.w / d, line.k / d};
}

std::vector<PlaneCurve> circle(LatticePoint centre, std::int32_t radius, bool is_transparent) {
  const LatticePoint range{centre.x - radius, centre.x + radius};
  return {PlaneCurve::arc(Kind::near_arc, centre, radius, range, is_transparent),
          PlaneCurve::arc(Kind::far_arc, centre, radius, range, is_transparent)};
}

int depth_order(const PlaneCurve& a, const PlaneCurve& b, std::int64_t numerator) {
  // Each depth is (rational + e sqrt(q)) / scale.
  struct Depth {
    Int128 rational, scale;
    int e;
    Int128 square;
  };
  const auto depth = [numerator](const PlaneCurve& c) -> Depth {
    if (!c.is_arc()) {
      const Int128 dx = c.right - c.left, dz = c.z_right - c.z_left;
      return {2 * dx * c.z_left + (numerator - 2 * Int128(c.left)) * dz, 2 * dx, 0, 0};
    }
    const Int128 from_middle = numerator - 2 * Int128(c.x_middle);
    return {2 * Int128(c.z_middle), 2, c.kind == Kind::far_arc ? 1 : -1,
            4 * Int128(c.radius_square) - from_middle * from_middle};
  };
  const Depth p = depth(a), q = depth(b);
  const WideInteger difference = WideInteger(p.rational) * q.scale - WideInteger(q.rational) * p.scale;
  return sign_with_roots(difference, p.e, WideInteger(p.square) * q.scale * q.scale, -q.e,
                         WideInteger(q.square) * p.scale * p.scale);
}

CurveMeeting meeting_of(const PlaneCurve& a, const PlaneCurve& b) {
  CurveMeeting result;
  const std::int64_t begin = std::max(a.left, b.left), end = std::min(a.right, b.right);
  if (begin >= end) return result;
  Meetings meetings(a, b, result);
  if (!a.is_arc() && !b.is_arc()) {
    const Line s = line_of(a), t = line_of(b);
    result.coincide = is_one_line(s, t);
    if (!result.coincide) meet_lines(s, t, meetings);
  } else if (a.is_arc() && b.is_arc()) {
    const Line line = radical_line(a, b);
    result.coincide = a.kind == b.kind && line.u == 0 && line.w == 0 && line.k == 0;
    if (line.w != 0) {
      meet_line(a, &b, line, meetings);
    } else if (!result.coincide) {
      meet_level(a, b, line, meetings);
    }
  } else {
    meet_line(a.is_arc() ? a : b, nullptr, line_of(a.is_arc() ? b : a), meetings);
  }
  if (result.coincide) return result;
  // Where the curves meet at both ends they meet nowhere else, so the order at the middle is that at the begin.
  result.order_at_begin = depth_order(a, b, 2 * begin);
  if (result.order_at_begin == 0) {
    const bool crosses = result.crosses[0] || result.crosses[1];
    result.order_at_begin = depth_order(a, b, 2 * end) * (crosses ? -1 : 1);
  }
  if (result.order_at_begin == 0) result.order_at_begin = depth_order(a, b, begin + end);
  return result;
}

}  // namespace ligne::studies
