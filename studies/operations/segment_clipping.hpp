#pragma once
/// Clipping of a segment by an axis-parallel rectangle, [Boulle1980] 3.2.3.1: by outcodes (Cohen and Sutherland) and by
/// bisection (Sproull and Sutherland).

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::studies {

struct ClipRectangle {
  double left, right, low, high;

  /// Outcode of figure 3.15: one bit for each side beyond which the point lies.
  unsigned code(Point2 p) const { return (p.x < left) | (p.x > right) << 1 | (p.y < low) << 2 | (p.y > high) << 3; }
};

struct ClipCounts {
  std::uint64_t codes = 0;      ///< computed outcodes
  std::uint64_t crossings = 0;  ///< computed crossings with a side
  std::uint64_t middles = 0;
};

using ClippedSegment = std::optional<std::pair<Point2, Point2>>;

/// The part within the rectangle, or nothing. Computes at most four crossings. The ends are exact up to rounding; a segment
/// that passes a corner of the rectangle closer than that may be classified wrongly.
inline ClippedSegment clip_by_codes(Point2 p, Point2 q, const ClipRectangle& r, ClipCounts& counts) {
  counts.codes += 2;
  unsigned of_p = r.code(p), of_q = r.code(q);
  for (;;) {
    if ((of_p | of_q) == 0) return std::pair(p, q);
    if ((of_p & of_q) != 0) return std::nullopt;
    const bool first = of_p != 0;
    Point2& end = first ? p : q;
    unsigned& code = first ? of_p : of_q;
    ++counts.crossings;
    const Point2 d = q - p;
    if (code & 1u) {
      end = {r.left, p.y + d.y * (r.left - p.x) / d.x};
    } else if (code & 2u) {
      end = {r.right, p.y + d.y * (r.right - p.x) / d.x};
    } else if (code & 4u) {
      end = {p.x + d.x * (r.low - p.y) / d.y, r.low};
    } else {
      end = {p.x + d.x * (r.high - p.y) / d.y, r.high};
    }
    ++counts.codes;
    code = r.code(end);
  }
}

/// A convex contour of at most 64 sides, with outcodes of one bit for each side beyond which a point lies, 3.2.3.1.
struct ClipContour {
  std::vector<Point2> corners;  ///< in positive orientation

  std::uint64_t code(Point2 p) const {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) bits |= std::uint64_t{height(i, p) < 0} << i;
    return bits;
  }
  /// Signed distance from side i, times the length of the side.
  double height(std::size_t i, Point2 p) const {
    const Point2 a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    return cross(b - a, p - a);
  }
};

/// The part within the contour, or nothing, by outcodes of n bits. Computes at most n crossings, one per side.
inline ClippedSegment clip_by_codes(Point2 p, Point2 q, const ClipContour& contour, ClipCounts& counts) {
  counts.codes += 2;
  std::uint64_t of_p = contour.code(p), of_q = contour.code(q);
  std::uint64_t done = 0;  // sides already clipped: rounding may leave a computed end slightly outside
  for (;;) {
    if ((of_p & of_q) != 0) return std::nullopt;
    if ((of_p | of_q) == 0) return std::pair(p, q);
    const bool first = of_p != 0;
    Point2& end = first ? p : q;
    std::uint64_t& code = first ? of_p : of_q;
    const auto side = static_cast<std::size_t>(std::countr_zero(code));
    const double at_p = contour.height(side, p), at_q = contour.height(side, q);
    ++counts.crossings;
    end = p + (q - p) * (at_p / (at_p - at_q));
    done |= std::uint64_t{1} << side;
    ++counts.codes;
    code = contour.code(end) & ~done;
    (first ? of_q : of_p) &= ~done;
  }
}

/// Clips on integer coordinates: bisection finds the farthest point of the segment within the rectangle from each end. Exact
/// to one step. On a screen of 2^k steps each end takes at most k bisections.
inline ClippedSegment clip_by_halving(Point2 p, Point2 q, const ClipRectangle& r, ClipCounts& counts) {
  counts.codes += 2;
  const unsigned of_p = r.code(p), of_q = r.code(q);
  if ((of_p | of_q) == 0) return std::pair(p, q);
  if ((of_p & of_q) != 0) return std::nullopt;
  /// The farthest inside point from `from`; `to` is outside. Empty if there is none.
  const auto farthest = [&](Point2 from, unsigned of_from, Point2 to, unsigned of_to) -> std::optional<Point2> {
    std::optional<Point2> best;
    if (of_from == 0) best = from;
    while (std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) > 1) {
      const Point2 middle{std::floor((from.x + to.x) / 2), std::floor((from.y + to.y) / 2)};
      ++counts.middles;
      ++counts.codes;
      const unsigned of_middle = r.code(middle);
      if (of_middle == 0) best = middle;
      // The half beyond the midpoint is outside: both of its ends lie beyond one side.
      if ((of_middle & of_to) != 0) {
        to = middle;
        of_to = of_middle;
      } else {
        from = middle;
        of_from = of_middle;
      }
      if ((of_from & of_to) != 0) return best;
    }
    return best;
  };
  const auto end = of_q == 0 ? std::optional(q) : farthest(p, of_p, q, of_q);
  if (!end) return std::nullopt;
  const auto begin = of_p == 0 ? std::optional(p) : farthest(q, of_q, p, of_p);
  if (!begin) return std::nullopt;
  return std::pair(*begin, *end);
}

}  // namespace ligne::studies
