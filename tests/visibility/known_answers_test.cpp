// Scenes whose visible lines are worked out by hand.

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr double kMicrometre = 0.001;

/// Is there a visible stroke (or a chain of them on one line) from a to b? Page mm relative to the page's centre, y down.
bool drawn(const Picture& picture, Point2 a, Point2 b) {
  const Point2 centre{kPageWidth / 2, kPageHeight / 2};
  a += centre;
  b += centre;
  const Point2 d = b - a;
  const double length = glm::length(d);
  std::vector<std::pair<double, double>> parts;
  for (const Stroke& s : picture.model.strokes) {
    if (!s.visible) continue;
    const Point2 p = picture.model.lattice.to_mm(s.from) - a, q = picture.model.lattice.to_mm(s.to) - a;
    const auto off = [&](Point2 v) { return std::abs(d.x * v.y - d.y * v.x) / length; };
    if (off(p) > kMicrometre || off(q) > kMicrometre) continue;
    const double tp = glm::dot(p, d) / length, tq = glm::dot(q, d) / length;
    parts.emplace_back(std::min(tp, tq), std::max(tp, tq));
  }
  std::sort(parts.begin(), parts.end());
  double reached = 0;
  for (const auto& [from, to] : parts) {
    if (from > reached + kMicrometre) break;
    reached = std::max(reached, to);
  }
  return reached >= length - kMicrometre;
}

TEST(KnownAnswers, CubeFromTheFrontIsASquare) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  CameraRequest front;
  front.named_view = "front";
  const Picture p = draw(scene, {front, "feature", false, 1});
  EXPECT_NEAR(p.length(), 40, kMicrometre);
  EXPECT_TRUE(drawn(p, {-5, -5}, {5, -5}));
  EXPECT_TRUE(drawn(p, {5, -5}, {5, 5}));
  EXPECT_TRUE(drawn(p, {-5, 5}, {5, 5}));
  EXPECT_TRUE(drawn(p, {-5, -5}, {-5, 5}));
  EXPECT_NEAR(p.length_of(LineClass::outline), 40, kMicrometre);
}

TEST(KnownAnswers, CubeInIsometryShowsNineEdges) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  CameraRequest iso;
  const Picture p = draw(scene, {iso, "all", true, 1});
  const double edge = 10 * std::sqrt(2.0 / 3);
  EXPECT_NEAR(p.length_of(LineClass::outline), 6 * edge, 6 * kMicrometre);
  EXPECT_NEAR(p.length_of(LineClass::crease), 3 * edge, 3 * kMicrometre);
  // The hidden corner lies behind the front one; its edges run to the other three corners of the hexagon.
  EXPECT_NEAR(p.length(false), 3 * edge, 3 * kMicrometre);
}

TEST(KnownAnswers, CubeSeenOffAxisHasThreeHiddenEdges) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  // Camera along (-1, 2, -1): x projects to length sqrt(5/6), y to sqrt(2/6), z to sqrt(5/6).
  const Picture p = draw(scene, {along({-1, 2, -1}), "all", true, 1});
  const double one_of_each = 10 * (2 * std::sqrt(5.0 / 6) + std::sqrt(2.0 / 6));
  EXPECT_NEAR(p.length(true), 3 * one_of_each, 9 * kMicrometre);
  EXPECT_NEAR(p.length(false), one_of_each, 3 * kMicrometre);
}

TEST(KnownAnswers, PlateBeforeCubeHidesWhatIsBehindIt) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  // A plate 4 x 4 before the middle of the cube's right side, seen from the front (along +y).
  add_face(scene, {{{8, -5, 3}, {12, -5, 3}, {12, -5, 7}, {8, -5, 7}}});
  CameraRequest front;
  front.named_view = "front";
  const Picture p = draw(scene, {front, "feature", false, 1});
  // The scene's box is x 0..12, z 0..10: its centre is (6, 5).
  EXPECT_NEAR(p.length(), 40 - 4 + 16, 2 * kMicrometre);
  EXPECT_TRUE(drawn(p, {4, -5}, {4, -2}));
  EXPECT_TRUE(drawn(p, {4, 2}, {4, 5}));
  EXPECT_FALSE(drawn(p, {4, -1.9}, {4, 1.9}));
  EXPECT_TRUE(drawn(p, {2, -2}, {6, -2}));
}

TEST(KnownAnswers, FaceSeenThroughAHole) {
  Scene scene;
  // A square plate with a square hole, before a bar that crosses the picture.
  add_face(scene, {{{-10, 0, -10}, {10, 0, -10}, {10, 0, 10}, {-10, 0, 10}}, {{-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4}}});
  add_face(scene, {{{-20, 5, -1}, {20, 5, -1}, {20, 5, 1}, {-20, 5, 1}}});
  CameraRequest front;
  front.named_view = "front";
  const Picture p = draw(scene, {front, "feature", false, 1});
  // The plate 80 + 32, the bar outside 2 x (2 x 10 + 2), through the hole 2 x 8.
  EXPECT_NEAR(p.length(), 80 + 32 + 44 + 16, 4 * kMicrometre);
  EXPECT_TRUE(drawn(p, {-4, -1}, {4, -1}));
  EXPECT_FALSE(drawn(p, {-9, -1}, {-5, -1}));
  EXPECT_TRUE(drawn(p, {-20, 1}, {-10, 1}));
}

TEST(KnownAnswers, ThreeBarsInCyclicOverlap) {
  // Three bars 12 x 2 that lie on each other in a ring: each is over the next, seen along -z.
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    const double a = i * 2 * std::acos(-1.0) / 3, c = std::cos(a), s = std::sin(a);
    const auto at = [&](double u, double v, double z) { return Point3{c * u - s * v, s * u + c * v, z}; };
    // Along u the bar rises from below the one before it to above the one after it.
    add_face(scene, {{at(-6, -3, -1), at(6, -3, 1), at(6, -1, 1), at(-6, -1, -1)}});
  }
  const Picture p = draw(scene, {along({0, 0, -1}), "feature", false, 1});
  // The bars' middle lines are tangents of a circle of radius 2 and cross at 60 degrees at u = +-2 sqrt(3). There each bar is
  // under one and over the other: it loses 2 x 2 / sin 60 of its long edges.
  EXPECT_NEAR(p.length(), 3 * (2 * 12 + 2 * 2 - 2 * 2 / std::sin(std::acos(-1.0) / 3)), 0.01);
}

TEST(KnownAnswers, TwoPenetratingBoxes) {
  // A bar 2 x 2 driven through a box 10 x 10 x 10 from front to back, sticking out 5, seen from the left, front and above.
  Scene scene;
  add_box(scene, {-5, -5, -5}, {10, 10, 10});
  add_box(scene, {-1, -10, -1}, {2, 20, 2});
  const Picture p = draw(scene, {along({1, 2, -1}), "intersection", false, 1});
  // On the front face the ring has sides of 2. The bar's left and top faces are seen, and where they enter the box the ring is
  // seen; the bar hides the other two sides of it. The box hides the ring at its back. x and z shrink by sqrt(5/6).
  EXPECT_NEAR(p.length_of(LineClass::intersection), 4 * std::sqrt(5.0 / 6), 2 * kMicrometre);
}

TEST(KnownAnswers, PenetratingPlanesCrossInALine) {
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

TEST(KnownAnswers, PlanesThatCrossInASideOfTriangles) {
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

TEST(KnownAnswers, ConvexShapeHidesItsBack) {
  // A tetrahedron seen onto one face: only the three sides of that face.
  Scene scene;
  begin_object(scene);
  scene.vertices = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {1, 1, -5}};
  for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
    scene.faces.add_triangle(t[0], t[1], t[2]);
  }
  end_object(scene);
  const Picture p = draw(scene, {along({0, 0, -1}), "all", true, 1});
  EXPECT_NEAR(p.length(), 12 + 6 * std::sqrt(2.0), 3 * kMicrometre);
  EXPECT_NEAR(p.length(false), std::sqrt(2.0) + 2 * std::sqrt(26.0), 3 * kMicrometre);
}

// Clipping gives the two halves corners of their own, and still they are known to go on in each other.
TEST(KnownAnswers, SurfaceThroughAPlateAlongAnEdgeThatIsClipped) {
  Scene scene;
  add_face(scene, {{{-200, -5, 0}, {200, -5, 0}, {200, 5, 0}, {-200, 5, 0}}});
  begin_object(scene);
  scene.vertices.insert(scene.vertices.end(), {{-200, 0, 0}, {200, 0, 0}, {200, 0, 4}, {-200, 0, 4}, {200, 0, -4}, {-200, 0, -4}});
  const std::uint32_t upper[] = {4, 5, 6, 7}, lower[] = {5, 4, 9, 8};
  scene.faces.add_face(upper);
  scene.faces.add_face(lower);
  end_object(scene);
  const Picture p = draw(scene, {along({0, 1, -1}), "intersection", false, 1});
  EXPECT_NEAR(p.length_of(LineClass::intersection), kPageWidth, kMicrometre);
}

}  // namespace
}  // namespace ligne::test
