// Faces clipped again: two halves of a face cut along one line, each by its own rounding of it, end on their common side a
// part of a step apart that the fine lattice can not tell. A contour that is closed there only on the fine lattice is open
// for lines that run through the gap.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "geometry/clip_contour_by_contour.hpp"

namespace ligne {
namespace {

ContourFace polygon(std::vector<LatticePoint> points) {
  return make_contour_face(std::vector<std::vector<LatticePoint>>{std::move(points)});
}

LatticePoint rounded(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}

/// A large quadrilateral on the left of the line through the two points, which are lattice points of one of its sides.
ContourFace left_half(LatticePoint p, LatticePoint q) {
  const std::int32_t dx = q.x - p.x, dy = q.y - p.y;
  const LatticePoint a{p.x - 3 * dx, p.y - 3 * dy}, b{p.x + 4 * dx, p.y + 4 * dy};
  return polygon({a, b, {b.x - 4 * dy, b.y + 4 * dx}, {a.x - 4 * dy, a.y + 4 * dx}});
}

struct Trial {
  std::vector<ContourFace> front;  ///< what is in front, of both halves
  ContourFace subject, other;
};

/// A square of two triangles with a line across their common side, rounded on each of them by itself; a triangle behind it,
/// and one more.
Trial trial(std::mt19937& random) {
  constexpr std::int32_t kSide = 2'000'000;
  const auto number = [&](std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random);
  };
  const LatticePoint a{number(-99, 99), number(-99, 99)}, c{kSide + number(-99, 99), kSide + number(-99, 99)};
  const LatticePoint b{kSide + number(-99, 99), number(-99, 99)}, d{number(-99, 99), kSide + number(-99, 99)};
  // From the right side through the middle part of the diagonal to the left side.
  const double t = 0.3 + 0.4 * number(0, 1000) / 1000.0, slope = 0.5 * number(-1000, 1000) / 997.0;
  const double mx = a.x + t * (c.x - a.x), my = a.y + t * (c.y - a.y);
  const LatticePoint right = rounded(mx + 0.25 * kSide, my + slope * 0.25 * kSide),
                     left = rounded(mx - 0.25 * kSide, my - slope * 0.25 * kSide);
  const LatticePoint middle = rounded(mx, my);
  Trial result;
  const auto add = [&](const ContourFace& half, const ContourFace& side) {
    ClipResult part = clip_contour_by_contour(std::vector{half}, std::vector{side}, true);
    std::move(part.inside.begin(), part.inside.end(), std::back_inserter(result.front));
  };
  add(polygon({a, b, c}), left_half(middle, right));
  add(polygon({a, c, d}), left_half(left, middle));
  result.subject =
      polygon({{number(-kSide, 0), number(-kSide, 0)}, {2 * kSide, number(0, kSide)}, {number(0, kSide), 2 * kSide}});
  result.other = polygon(
      {{number(0, kSide), number(-kSide, 0)}, {2 * kSide, number(kSide, 2 * kSide)}, {number(-kSide, 0), number(0, kSide)}});
  return result;
}

/// Corners of areas are rounded to the fine lattice.
constexpr double kRounding = 1e-10;

/// How much the areas of what was clipped, in two orders, do not add up, as parts of the subject's area.
double fault(const Trial& t, bool closed) {
  const std::vector<ContourFace> subject{t.subject}, other{t.other};
  const ClipResult first = clip_contour_by_contour(subject, t.front, closed);
  const ClipResult front = clip_contour_by_contour(first.inside, other, closed),
                   rest = clip_contour_by_contour(first.outside, other, closed);
  const ClipResult whole = clip_contour_by_contour(subject, other, closed),
                   again = clip_contour_by_contour(whole.inside, first.inside, closed);
  const double area = twice_area(t.subject);
  const double sums[] = {twice_area(first.inside) + twice_area(first.outside) - area,
                         twice_area(front.inside) + twice_area(front.outside) - twice_area(first.inside),
                         twice_area(rest.inside) + twice_area(rest.outside) - twice_area(first.outside),
                         twice_area(front.inside) + twice_area(rest.inside) - twice_area(whole.inside),
                         twice_area(again.inside) - twice_area(front.inside)};
  double worst = 0;
  for (const double s : sums) worst = std::max(worst, std::abs(s) / area);
  return worst;
}

TEST(ClipClosed, WhatIsClippedAgainAddsUp) {
  std::mt19937 random(5);
  int open = 0;
  for (int i = 0; i < 3000; ++i) {
    const Trial t = trial(random);
    EXPECT_LT(fault(t, true), kRounding) << "trial " << i;
    open += fault(t, false) > kRounding;
  }
  EXPECT_GT(open, 0) << "the gap is no danger: what is this option for?";
}

}  // namespace
}  // namespace ligne
