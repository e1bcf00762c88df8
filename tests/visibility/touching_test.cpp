// Solids that touch: every line once, and all of it.

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr int kSide = 8;

enum class Corners { exact, rotated_corners, rotated_centres };

/// 8 x 8 x 8 unit cubes face to face, each its own object, with the corners rounded to double after a rotation in one of two
/// ways: corner by corner (common corners stay equal), or as centre plus half-diagonals (they differ in the last bits).
Scene cubes(Corners corners, const Basis& basis) {
  Scene scene;
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const Point3 corner{double(i), double(j), double(k)};
        if (corners != Corners::rotated_centres) {
          add_box(scene, corner, {1, 1, 1}, basis);
          continue;
        }
        const Point3 c = corner + Point3{0.5, 0.5, 0.5};
        const Point3 centre = basis[0] * c.x + basis[1] * c.y + basis[2] * c.z;
        add_box(scene, {-0.5, -0.5, -0.5}, {1, 1, 1}, basis);
        for (std::size_t v = scene.vertices.size() - 8; v < scene.vertices.size(); ++v) scene.vertices[v] += centre;
        scene.objects.back().precision = kSide * 0x1p-52;
      }
    }
  }
  return scene;
}

/// On each of the three visible sides of the block 9 + 9 lines of length 8; the 24 units on the three inner edges and on
/// the rim belong to two sides where they meet.
double ideal_length(const Picture& picture, const Basis& basis) {
  double sum = 0;
  const Camera& camera = picture.projected.view.camera;
  for (const Point3& axis : basis) {
    const double seen = std::sqrt(1 - std::pow(glm::dot(axis, camera.forward), 2)) * picture.projected.view.scale;
    // Lines along this axis: 9 + 9 on the two visible sides that contain it, one of them common to both.
    sum += (2 * (kSide + 1) - 1) * kSide * seen;
  }
  return sum;
}

class TouchingCubes : public testing::TestWithParam<Corners> {};

TEST_P(TouchingCubes, EveryLineOnceAndAllOfIt) {
  const Basis basis = GetParam() == Corners::exact ? kUpright : rotation(0.3, 0.7, -1.1);
  const Scene scene = cubes(GetParam(), basis);
  for (const char* edges : {"feature", "all"}) {
    for (const Point3& direction : {Point3{-1, 1, -1}, Point3{0.3, 0.5, -0.8}, Point3{-0.11, 0.93, 0.2}}) {
      const Picture p = draw(scene, {along(direction), edges});
      EXPECT_NEAR(p.length() / ideal_length(p, basis), 1, 0.0005) << edges << " along " << direction.x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllCorners, TouchingCubes,
                         testing::Values(Corners::exact, Corners::rotated_corners, Corners::rotated_centres));

TEST(TouchingCubes, SeenStraightOn) {
  const Scene scene = cubes(Corners::exact, kUpright);
  CameraRequest front;
  front.named_view = "front";
  const Picture p = draw(scene, {front, "all", false, 10});
  EXPECT_NEAR(p.length(), 2 * (kSide + 1) * kSide * 10, 0.001 * 2 * (kSide + 1) * kSide);
}

TEST(Touching, BoxOnAPlateShowsItsFoot) {
  Scene scene;
  add_box(scene, {-10, -10, -1}, {20, 20, 1});
  add_box(scene, {-2, -2, 0}, {4, 4, 4});
  const Picture p = draw(scene, {along({-1, 1, -1}), "feature", false, 1});
  // Plate and box show nine edges each; the box hides parts of the plate's two back edges? No: the plate reaches 8 units
  // beyond the box on every side, and the box is 4 high: all of the plate's edges are seen.
  const double unit = std::sqrt(2.0 / 3);
  EXPECT_NEAR(p.length(), unit * (3 * 20 + 3 * 20 + 3 * 1 + 9 * 4), 0.02);
  EXPECT_NEAR(p.length_of(LineClass::intersection), 0, 0.001) << "what touches does not penetrate";
}

TEST(Touching, CoplanarPlatesHideNothingOfEachOther) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}});
  add_face(scene, {{{5, 5, 0}, {15, 5, 0}, {15, 15, 0}, {5, 15, 0}}});
  const Picture p = draw(scene, {along({0.1, 0.3, -1}), "feature", false, 1});
  const Picture first = draw(
      [] {
        Scene s;
        add_face(s, {{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}});
        return s;
      }(),
      {along({0.1, 0.3, -1}), "feature", false, 1});
  EXPECT_NEAR(p.length(), 2 * first.length(), 0.01);
}

TEST(Touching, DuplicateFacesAreDrawnOnce) {
  Scene scene;
  for (int i = 0; i < 3; ++i) add_box(scene, {0, 0, 0}, {10, 10, 10});
  const Picture p = draw(scene, {along({-1, 2, -1}), "all", true, 1});
  Scene one;
  add_box(one, {0, 0, 0}, {10, 10, 10});
  const Picture q = draw(one, {along({-1, 2, -1}), "all", true, 1});
  EXPECT_NEAR(p.length(), q.length(), 0.001);
  EXPECT_NEAR(p.length(false), q.length(false), 0.001);
}

// A corner beside a facet sees the errors of the facet's corners enlarged: the fourth corner of a parallelogram three times.
TEST(Touching, OnePlateCutByEitherDiagonalDoesNotPenetrateItself) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}}});
  add_face(scene, {{{0, 0, 0}, {4, 0, 4}, {0, 0, 4}}});
  add_face(scene, {{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}});
  add_face(scene, {{{4, 0, 0}, {4, 0, 4}, {0, 0, 4}}});
  for (int i = 0; i < 64; ++i) {
    const Point3 eye{5.4375 + i / 16.0, -4.59375, 4.40625 + i / 32.0};
    EXPECT_EQ(draw(scene, {from_eye(eye, {2, 0, 2})}).length_of(LineClass::intersection), 0) << "from " << eye.x;
  }
}

}  // namespace
}  // namespace ligne::test
