// Planes that cross where rims or sides of triangles lie. Scenes with all coordinates worked out: tests/known_answers.

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr double kMicrometre = 0.001;

TEST(PenetratingPlanes, CrossInALineThoughTheirRimsCoincide) {
  // Two 10 x 10 squares that cross at right angles along x, seen along (0, 1, -1): both are seen at 45 degrees.
  Scene scene;
  add_face(scene, {{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  add_face(scene, {{{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}}});
  const Picture p = draw(scene, {along({0, 1, -1}), "all", false, 1});
  EXPECT_NEAR(p.length_of(LineClass::intersection), 10, kMicrometre);
  // Both project to the same rectangle 10 x 10/sqrt(2): of each the far half is behind the near half of the other, and both
  // rectangles' rims coincide. Drawn: the rim once, and the line of intersection.
  EXPECT_NEAR(p.length(), 20 + 2 * 10 / std::sqrt(2.0) + 10, 5 * kMicrometre);
}

TEST(PenetratingPlanes, CrossInASideOfTriangles) {
  // The upright square is cut into triangles along the very line in which it crosses the other one, and the lower half
  // hangs on the upper one by that side.
  Scene scene;
  add_face(scene, {{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  begin_object(scene);
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  for (const Point3& p : {Point3{-5, 0, 0}, Point3{5, 0, 0}, Point3{0, 0, 5}, Point3{0, 0, -5}}) scene.vertices.push_back(p);
  scene.faces.add_triangle(base, base + 1, base + 2);
  scene.faces.add_triangle(base + 1, base, base + 3);
  end_object(scene);
  for (const bool hidden : {false, true}) {
    const Picture p = draw(scene, {along({0, 1, -1}), "intersection", hidden, 1});
    EXPECT_NEAR(p.length_of(LineClass::intersection), 10, kMicrometre) << "with hidden lines: " << hidden;
  }
  // Without the lower half the upper one stands on the square: they touch.
  Scene standing = scene;
  standing.faces = {};
  add_face(standing, {{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}});
  add_face(standing, {{{-5, 0, 0}, {5, 0, 0}, {0, 0, 5}}});
  EXPECT_NEAR(draw(standing, {along({0, 1, -1}), "intersection", false, 1}).length(), 0, kMicrometre);
}

// Clipping gives the two halves corners of their own, and still they are known to go on in each other.
TEST(PenetratingPlanes, SurfaceThroughAPlateAlongAnEdgeThatIsClipped) {
  Scene scene;
  add_face(scene, {{{-200, -5, 0}, {200, -5, 0}, {200, 5, 0}, {-200, 5, 0}}});
  begin_object(scene);
  scene.vertices.insert(scene.vertices.end(),
                        {{-200, 0, 0}, {200, 0, 0}, {200, 0, 4}, {-200, 0, 4}, {200, 0, -4}, {-200, 0, -4}});
  const std::uint32_t upper[] = {4, 5, 6, 7}, lower[] = {5, 4, 9, 8};
  scene.faces.add_face(upper);
  scene.faces.add_face(lower);
  end_object(scene);
  const Picture p = draw(scene, {along({0, 1, -1}), "intersection", false, 1});
  EXPECT_NEAR(p.length_of(LineClass::intersection), kPageWidth, kMicrometre);
}

// Two squares that cross in the diagonal along which both are cut into triangles; and two roofs that only touch along their
// ridges.
TEST(PenetratingPlanes, CrossInADiagonalOfBoth) {
  for (const int turn : {0, 1}) {
    const auto turned = [turn](std::vector<Point3> p) {
      std::rotate(p.begin(), p.begin() + turn, p.end());
      return p;
    };
    Scene scene;
    add_face(scene, {turned({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}})});
    add_face(scene, {turned({{0, 0, 0}, {4, 0, 4}, {4, 4, 0}, {0, 4, -4}})});
    const Picture p = draw(scene, {along({0, 0, -1}), "intersection", false, 1});
    EXPECT_NEAR(p.length_of(LineClass::intersection), 4 * std::sqrt(2.0), kMicrometre) << turn;
  }
}

TEST(PenetratingPlanes, RoofsThatTouchAlongTheirRidgesDoNotCross) {
  Scene scene;
  for (const double z : {-1, 1}) {
    add_face(scene, {{{0, 0, 0}, {4, 0, 0}, {4, 2, z}, {0, 2, z}}});
    add_face(scene, {{{4, 0, 0}, {0, 0, 0}, {0, -2, z}, {4, -2, z}}});
  }
  EXPECT_NEAR(draw(scene, {along({0, 0, -1}), "intersection", false, 1}).length_of(LineClass::intersection), 0, kMicrometre);
}

}  // namespace
}  // namespace ligne::test
