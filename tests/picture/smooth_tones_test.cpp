// Gray faces of continuous tone against the tone of the surface itself.

#include "picture/hatching/smooth_tones.hpp"
#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/fills.hpp"
#include "support/round_bodies.hpp"
#include "support/test.hpp"
#include "view/brightness.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// A ball of radius 1 about the origin, of triangles that are a few degrees high.
Scene fine_ball(unsigned rows) {
  return test::ball(2 * rows, rows - 1, [](auto, auto) { return 1.0; });
}

PictureRequest request_from(const ViewRequest& view) {
  PictureRequest request;
  request.lines.method = find_method("watkins");
  request.lines.quality = Quality::exact;
  request.gray_faces = true;
  request.gray_tone = GrayTone::smooth;
  request.view = view;
  return request;
}

/// Calls visit(face, point of the face on the ball) for points over all faces that are seen from above.
template <class Visit>
void for_points_above(const Scene& scene, Visit visit) {
  for (std::uint32_t face = 0; face < scene.faces.size(); ++face) {
    const auto v = scene.faces.contour(face, 0);
    for (const std::array<double, 3> w : {std::array{0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}, {0.3, 0.3, 0.4}}) {
      Point3 p{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) p += w[k] * scene.vertices[v[k]];
      if (p.z > 0.1) visit(face, p);
    }
  }
}

/// From above the normal at distance r from the middle has the height sqrt(1 - r^2), so the tone is 1 - r^2.
TEST(SmoothTones, AreThoseOfABall) {
  const Scene scene = fine_ball(24);
  ViewRequest above;
  above.named_view = "top";
  RunReport run;
  const PreparedScene prepared = prepare(scene, request_from(above), std::nullopt, run);
  const SmoothTones tones(prepared);
  const std::vector<double> of_face = face_brightness(scene, prepared.view().camera);
  double worst = 0, worst_by_face = 0;
  for_points_above(scene, [&](std::uint32_t face, const Point3& p) {
    const double expected = 1 - (p.x * p.x + p.y * p.y);
    worst = std::max(worst, std::abs(tones.at(face, page_point(prepared.view(), p)) - expected));
    worst_by_face = std::max(worst_by_face, std::abs(of_face[face] - expected));
  });
  constexpr double kNear = 0.02;
  EXPECT_LT(worst, kNear);
  EXPECT_GT(worst_by_face, 2 * kNear) << "one tone a face is not so near";
}

/// In perspective the point under a pixel is found with its depth: cos^2 / R^2 of the ball, over the largest of a face.
TEST(SmoothTones, AreThoseOfABallInPerspective) {
  const Scene scene = fine_ball(24);
  ViewRequest near;
  near.eye = Point3{0.3, 0.2, 3};
  near.target = Point3{0, 0, 0};
  near.up = Point3{0, 1, 0};
  RunReport run;
  const PreparedScene prepared = prepare(scene, request_from(near), std::nullopt, run);
  const SmoothTones tones(prepared);
  const double factor = eye_brightness_factor(scene, prepared.view().camera);
  for_points_above(scene, [&](std::uint32_t face, const Point3& p) {
    const Point3 normal = glm::normalize(p), sight = p - *near.eye;
    if (glm::dot(normal, glm::normalize(sight)) > -0.2) return;  // near the outline and beyond it
    const double cosine = glm::dot(normal, sight), square = glm::dot(sight, sight);
    const double expected = std::min(1.0, factor * cosine * cosine / (square * square));
    EXPECT_NEAR(tones.at(face, page_point(prepared.view(), p)), expected, 0.02);
  });
}

/// Between creases a flat face has one tone, that of its face.
TEST(SmoothTones, OfFlatFacesAreThoseOfFaces) {
  const Scene scene = fine_ball(3);  // its faces turn by more than the angle of creases
  RunReport run;
  const PreparedScene prepared = prepare(scene, request_from({}), std::nullopt, run);
  const SmoothTones tones(prepared);
  const std::vector<double> of_face = face_brightness(scene, prepared.view().camera);
  std::size_t points = 0;
  for_points_above(scene, [&](std::uint32_t face, const Point3& p) {
    EXPECT_EQ(tones.at(face, page_point(prepared.view(), p)), of_face[face]);
    ++points;
  });
  EXPECT_GT(points, 10u);
}

/// Lit colours: with a light from above the colour of a red ball is (0.35 + 0.65 z) times red, by the normal z at the point.
TEST(SmoothTones, ColoursAreThoseOfALitBall) {
  Scene scene = fine_ball(24);
  scene.materials = {{"red", {0.8, 0.4, 0.2}, 1}};
  scene.lights = {{Light::Kind::parallel, {0, 0, -2}}};
  ViewRequest above;
  above.named_view = "top";
  PictureRequest request = request_from(above);
  request.gray_faces = false;
  request.fill.kind = FillKind::shade;
  RunReport run;
  const PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  ASSERT_EQ(prepared.lights.size(), 1u);
  const SmoothTones tones(prepared);
  const SmoothFillColors colors(scene, prepared.view().camera, prepared.lights);
  double worst = 0, worst_by_face = 0;
  for_points_above(scene, [&](std::uint32_t face, const Point3& p) {
    const double light = 0.35 + 0.65 * p.z / glm::length(p);
    const auto color = colors.of(face, tones.surface_at(face, page_point(prepared.view(), p)));
    const auto of_face = colors.of(face, std::nullopt);
    EXPECT_NEAR(color[1] / color[0], 0.5, 1e-12);
    EXPECT_NEAR(color[2] / color[0], 0.25, 1e-12);
    worst = std::max(worst, std::abs(color[0] - 0.8 * light));
    worst_by_face = std::max(worst_by_face, std::abs(of_face[0] - 0.8 * light));
  });
  EXPECT_LT(worst, 0.005);
  EXPECT_GT(worst_by_face, 0.02) << "one tone a face is not so near";
}

/// The whole picture of a ball in colour is an image in each vector file, and needs spans or pixels.
TEST(SmoothTones, ColoursAreAnImage) {
  Scene scene = fine_ball(12);
  scene.materials = {{"red", {1, 0, 0}, 1}};
  PictureRequest request = request_from({});
  request.gray_faces = false;
  request.fill.kind = FillKind::shade;
  for (const char* method : {"watkins", "zbuffer"}) {
    request.lines.method = find_method(method);
    RunReport run;
    const std::string svg = draw_scene(scene, request, run).bytes;
    EXPECT_NE(svg.find("<image "), std::string::npos) << method;
    EXPECT_EQ(svg.find("id=\"fill\""), std::string::npos) << method;
  }
  request.lines.method = find_method("newell");
  RunReport run;
  EXPECT_THROW(draw_scene(scene, request, run), RequestError);
  request.gray_tone = GrayTone::face;
  EXPECT_NO_THROW(draw_scene(scene, request, run));
}

}  // namespace
}  // namespace ligne
