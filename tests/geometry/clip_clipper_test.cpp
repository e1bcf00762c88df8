// The clip against an independent library: Clipper 6, which works on whole numbers too. Its corners are rounded to its
// lattice, which is made 2^16 times finer than ours.

#include <polyclipping/clipper.hpp>

#include "clip_support.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

ClipperLib::Paths paths(const ContourFace& face) {
  ClipperLib::Paths result;
  for (const EdgeLoop& loop : face.contours) {
    ClipperLib::Path path;
    for (const ContourEdge& e : loop) path.emplace_back(e.begin().x, e.begin().y);
    result.push_back(path);
  }
  return result;
}

double twice_area_by_clipper(const ContourFace& subject, const ContourFace& clip, ClipperLib::ClipType type) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths(subject), ClipperLib::ptSubject, true);
  clipper.AddPaths(paths(clip), ClipperLib::ptClip, true);
  ClipperLib::Paths solution;
  EXPECT_TRUE(clipper.Execute(type, solution, ClipperLib::pftPositive, ClipperLib::pftPositive));
  double area = 0;
  for (const ClipperLib::Path& path : solution) area += ClipperLib::Area(path);
  return std::ldexp(2 * area, -2 * kFineBits);
}

void expect_agreement(const ContourFace& a, const ContourFace& b) {
  const ClipResult result = clip_contour_by_contour(a, b);
  // Clipper rounds to the same fine lattice, and adds areas in doubles about the origin.
  const double tolerance = 4 * (area_tolerance({a, b}) + area_tolerance(result.inside) + area_tolerance(result.outside)) +
                           0x1p-44 * kLatticeLimit * kLatticeLimit;
  EXPECT_NEAR(twice_area(result.inside), twice_area_by_clipper(a, b, ClipperLib::ctIntersection), tolerance);
  EXPECT_NEAR(twice_area(result.outside), twice_area_by_clipper(a, b, ClipperLib::ctDifference), tolerance);
}

TEST(ClipAgainstClipper, Stars) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> place(-kLatticeLimit / 4, kLatticeLimit / 4);
  for (int i = 0; i < (runs_all() ? 20'000 : 5'000) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    expect_agreement(random_star(random, {place(random), place(random)}, kLatticeLimit * 0.6, i % 2 == 0),
                     random_star(random, {place(random), place(random)}, kLatticeLimit * 0.6, i % 3 == 0));
  }
}

TEST(ClipAgainstClipper, StarsOnASmallLattice) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int32_t> place(-3, 3);
  const auto star = [&](bool holes) {
    ContourFace f = random_star(random, {place(random), place(random)}, 5, holes);
    return f;
  };
  for (int i = 0; i < (runs_all() ? 50'000 : 12'500) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    expect_agreement(star(false), star(false));
  }
}

}  // namespace
}  // namespace ligne::test
