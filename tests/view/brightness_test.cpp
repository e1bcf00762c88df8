// The light at the eye.

#include <gtest/gtest.h>

#include "support/scene_parts.hpp"
#include "view/brightness.hpp"

namespace ligne::test {
namespace {

/// Seen along a diagonal of the cube all its faces are alike; along (0, 1, 1) four are, and two are edge on.
TEST(Brightness, ParallelIsTheSquareOfTheCosine) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  CameraRequest request;
  request.direction = Point3{1, 1, 1};
  for (const double b : face_brightness(scene, make_camera(request, scene))) EXPECT_NEAR(b, 1, 1e-12);
  request.direction = Point3{0, 1, 1};
  int dark = 0, full = 0;
  for (const double b : face_brightness(scene, make_camera(request, scene))) {
    dark += b < 1e-12;
    full += b > 1 - 1e-12;
  }
  EXPECT_EQ(dark, 2);
  EXPECT_EQ(full, 4);
}

/// Two plates that look at the eye, one twice as far away: a quarter of the light. One behind the eye gets none.
TEST(Brightness, PerspectiveFallsWithTheSquareOfTheDistance) {
  Scene scene;
  for (const double y : {1.0, 2.0, -1.0}) add_face(scene, {{{-1, y, -1}, {1, y, -1}, {1, y, 1}, {-1, y, 1}}});
  CameraRequest request;
  request.eye = Point3{0, 0, 0};
  request.target = Point3{0, 1, 0};
  const std::vector<double> b = face_brightness(scene, make_camera(request, scene));
  EXPECT_NEAR(b[0], 1, 1e-12);
  EXPECT_NEAR(b[1], 0.25, 1e-12);
  EXPECT_EQ(b[2], 0);
}

}  // namespace
}  // namespace ligne::test
