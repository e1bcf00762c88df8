/// Curves through points.

#include "scene/patches/swept/profile_curve.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kPi = std::numbers::pi;

Point2 on_ellipse(double a, double b, double angle) { return {a * std::cos(angle), b * std::sin(angle)}; }

ProfileCurve ellipse(double a, double b, int n, int sides, bool is_closed) {
  std::vector<Point2> points;
  for (int i = 0; i < sides + (is_closed ? 0 : 1); ++i) points.push_back(on_ellipse(a, b, 2 * kPi * i / n));
  return {points, is_closed, false};
}

/// Largest distance of true points of an ellipse from its curve.
double error_of(const ProfileCurve& curve, double a, double b, double turn) {
  double most = 0;
  for (double t = 0; t <= turn; t += 0.01) most = std::max(most, std::abs(curve.foot(on_ellipse(a, b, t)).distance));
  return most;
}

// The sag of the polygon is 0.34 and 0.086.
TEST(ProfileCurve, FollowsCirclesClosely) {
  for (const bool is_closed : {false, true}) {
    const ProfileCurve curve = ellipse(10, 10, 12, is_closed ? 12 : 6, is_closed);
    EXPECT_LT(error_of(curve, 10, 10, kPi), 1e-3) << is_closed;
    const ProfileCurve::Foot foot = curve.foot({9, 9});
    EXPECT_NEAR(foot.distance, 9 * std::sqrt(2.0) - 10, 1e-3);
    EXPECT_NEAR(foot.curvature, 0.1, 2e-3);
    EXPECT_LT(glm::distance(foot.normal, Point2(std::sqrt(0.5))), 2e-3);
  }
}

// The sag of the polygon is up to 0.086.
TEST(ProfileCurve, FollowsEllipsesFarWithinTheSag) {
  EXPECT_LT(error_of(ellipse(10, 5, 24, 24, true), 10, 5, 2 * kPi), 0.015);
  EXPECT_LT(error_of(ellipse(10, 5, 24, 6, false), 10, 5, kPi / 2), 0.02);
  EXPECT_LT(error_of(ellipse(10, 5, 48, 48, true), 10, 5, 2 * kPi), 0.002);
}

TEST(ProfileCurve, KeepsItsPointsAndGoesOnStraightBeyondItsEnds) {
  const ProfileCurve curve = ellipse(10, 5, 24, 6, false);
  for (const Point2& p : curve.points()) EXPECT_NEAR(curve.foot(p).distance, 0, 1e-12);
  const Point2 normal = curve.foot(curve.points()[0]).normal;
  EXPECT_NEAR(curve.foot(curve.points()[0] + 3.0 * Point2(normal.y, -normal.x)).distance, 0, 1e-9);
  EXPECT_GT(normal.x, 0.99);
}

TEST(ProfileCurve, IsSymmetricAtThePoleOfABallAndNotAtATip) {
  std::vector<Point2> ball, tip;
  for (int i = 0; i <= 6; ++i) {
    ball.emplace_back(10 * std::sin(kPi * i / 12), -10 * std::cos(kPi * i / 12));
    tip.emplace_back(i, i + 0.02 * i * i);
  }
  ball[0].x = 0;
  EXPECT_LT(glm::distance(ProfileCurve(ball, false, true).foot(ball[0]).normal, Point2(0, -1)), 1e-12);
  EXPECT_GT(std::abs(ProfileCurve(tip, false, true).foot(tip[0]).normal.x), 0.6);
}

}  // namespace
}  // namespace ligne
