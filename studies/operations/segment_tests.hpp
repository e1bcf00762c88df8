#pragma once
/// Segment against segment, C_S^S of [Boulle1980] 3.2.1.1: four tests of whether two segments cross.
///
/// N is double, a 128-bit integer, or the counting form of either (counting.hpp). With integers all four are exact for
/// |coordinates| <= 2^25, the lattice of the page. With doubles the first three are exact there too, since their
/// signs and quotients are formed from integers below 2^53; min-max rounds the crossing.
///
/// The first three test whether the segments cross in an inner point of both. min-max tests whether they share a point and
/// are not parallel. Exchanging the segments, or the ends of either, does not change the answer.

#include <type_traits>

#include "studies/counting.hpp"

namespace ligne::studies {

template <class N>
struct PlanePoint {
  N x, y;
};

template <class N>
struct DividesImpl : std::bool_constant<std::is_floating_point_v<N>> {};
template <class T>
struct DividesImpl<Counted<T>> : DividesImpl<T> {};
/// True if N is a floating point type, counted or not, so that quotients keep their fraction.
template <class N>
inline constexpr bool kDivides = DividesImpl<N>::value;

/// A and B lie on opposite sides of line CD, and C and D on opposite sides of line AB, by signs of a x + b y + c.
template <class N>
bool cross_analytic(const PlanePoint<N>& a, const PlanePoint<N>& b, const PlanePoint<N>& c, const PlanePoint<N>& d) {
  const N zero = constant_like(a.x, 0);
  const auto apart = [&](const PlanePoint<N>& from, const PlanePoint<N>& to, const PlanePoint<N>& p,
                         const PlanePoint<N>& q) {
    const N u = from.y - to.y, v = to.x - from.x, w = from.x * to.y - to.x * from.y;
    return (u * p.x + v * p.y + w) * (u * q.x + v * q.y + w) < zero;
  };
  const bool first = apart(c, d, a, b), second = apart(a, b, c, d);
  count_test(a.x);
  return first && second;
}

template <class N>
N cross_product(const PlanePoint<N>& p, const PlanePoint<N>& q) {
  return p.x * q.y - p.y * q.x;
}

template <class N>
PlanePoint<N> difference(const PlanePoint<N>& p, const PlanePoint<N>& q) {
  return {p.x - q.x, p.y - q.y};
}

/// (AC x AD) . (BC x BD) < 0 and (CA x CB) . (DA x DB) < 0.
template <class N>
bool cross_vector(const PlanePoint<N>& a, const PlanePoint<N>& b, const PlanePoint<N>& c, const PlanePoint<N>& d) {
  const N zero = constant_like(a.x, 0);
  const PlanePoint<N> ac = difference(c, a), ad = difference(d, a), bc = difference(c, b), bd = difference(d, b);
  const bool first = cross_product(ac, ad) * cross_product(bc, bd) < zero;
  const bool second = cross_product(ac, bc) * cross_product(ad, bd) < zero;  // CA x CB = AC x BC
  count_test(a.x);
  return first && second;
}

/// The parameters of the crossing on both segments lie strictly between 0 and 1.
template <class N>
bool cross_parametric(const PlanePoint<N>& a, const PlanePoint<N>& b, const PlanePoint<N>& c, const PlanePoint<N>& d) {
  const N zero = constant_like(a.x, 0), one = constant_like(a.x, 1);
  N ux, uy, vx, vy, ex, ey, det;
  ux = b.x - a.x;
  uy = b.y - a.y;
  vx = d.x - c.x;
  vy = d.y - c.y;
  ex = c.x - a.x;
  ey = c.y - a.y;
  det = ux * vy - uy * vx;
  if (det == zero) return false;
  const N s = ex * vy - ey * vx, t = ex * uy - ey * ux;
  if constexpr (kDivides<N>) {
    const N of_ab = s / det, of_cd = t / det;
    return of_ab > zero && of_ab < one && of_cd > zero && of_cd < one;
  } else {
    return det > zero ? s > zero && s < det && t > zero && t < det : s < zero && s > det && t < zero && t > det;
  }
}

template <class N>
const N& lesser(const N& p, const N& q) {
  return q < p ? q : p;
}
template <class N>
const N& greater(const N& p, const N& q) {
  return p < q ? q : p;
}

/// [Giloi1978]: the crossing of the two lines lies in the bounding boxes of both segments.
template <class N>
bool meet_min_max(const PlanePoint<N>& a, const PlanePoint<N>& b, const PlanePoint<N>& c, const PlanePoint<N>& d) {
  const N zero = constant_like(a.x, 0);
  const N a1 = b.y - a.y, b1 = a.x - b.x, c1 = a1 * a.x + b1 * a.y;
  const N a2 = d.y - c.y, b2 = c.x - d.x, c2 = a2 * c.x + b2 * c.y;
  N det;
  det = a1 * b2 - a2 * b1;
  if (det == zero) return false;
  /// True if v / det lies between p and q, and between r and s.
  const auto within = [&](const N& v, const N& p, const N& q, const N& r, const N& s) {
    const N &low = greater(lesser(p, q), lesser(r, s)), &high = lesser(greater(p, q), greater(r, s));
    if constexpr (kDivides<N>) {
      const N place = v / det;
      const bool above = place >= low, below = place <= high;
      return above && below;
    } else {
      const N least = low * det, most = high * det;
      return det > zero ? v >= least && v <= most : v <= least && v >= most;
    }
  };
  const bool in_x = within(c1 * b2 - c2 * b1, a.x, b.x, c.x, d.x), in_y = within(a1 * c2 - a2 * c1, a.y, b.y, c.y, d.y);
  return in_x && in_y;
}

}  // namespace ligne::studies
