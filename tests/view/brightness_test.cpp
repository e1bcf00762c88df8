// The light at the eye.

#include <gtest/gtest.h>

#include <cmath>

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

/// With lights: the mean of the cosines, without those that do not reach the face or stand behind it. Without: the light at
/// the eye.
TEST(Brightness, LightsGiveTheMeanOfTheirCosines) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  CameraRequest request;
  request.direction = Point3{0, 1, -1};
  const Camera camera = make_camera(request, scene);
  const std::vector<Light> lights{
      {Light::Kind::parallel, {0, 0, -2}}, {Light::Kind::parallel, {1, 0, -1}}, {Light::Kind::parallel, {0, 0, 1}}};
  const FaceLight light(scene, camera, lights);
  const double slanted = std::sqrt(0.5);
  EXPECT_NEAR(light.of(0), (1 + slanted) / 3, 1e-12);
  EXPECT_NEAR(light.of(0, 0b110), slanted / 3, 1e-12);
  EXPECT_EQ(light.of(0, 0), 0);
  const std::vector<Light> above{{Light::Kind::point, {0, 0, 5}}};
  EXPECT_NEAR(FaceLight(scene, camera, above).of(0), 1, 1e-12);
  EXPECT_EQ(FaceLight(scene, camera, {}).of(0), face_brightness(scene, camera)[0]);
}

}  // namespace
}  // namespace ligne::test
