/// Surfaces that touch: what clear lines leave out of their intersections, and what they keep.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "picture/scene_study.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "support/scene_parts.hpp"

namespace ligne {
namespace {

using test::begin_object;
using test::end_object;

/// A tube without ends round the axis `along`: n flat sides whose edges lie on the cylinder of this radius.
void add_tube(Scene& scene, int n, double radius, const Point3& from, const Point3& along, double turn) {
  begin_object(scene, "tube");
  const Point3 axis = glm::normalize(along);
  const Point3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Point3{1, 0, 0} : Point3{0, 1, 0}));
  const Point3 v = glm::cross(axis, u);
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / n;
    const Point3 p = from + radius * (std::cos(angle) * u + std::sin(angle) * v);
    scene.vertices.push_back(p);
    scene.vertices.push_back(p + along);
  }
  const auto m = static_cast<std::uint32_t>(2 * n);
  for (std::uint32_t i = 0; i < m; i += 2) {
    const std::uint32_t next = (i + 2) % m;
    const std::array<std::uint32_t, 4> corners{base + i, base + next, base + next + 1, base + i + 1};
    scene.faces.add_face(corners);
  }
  end_object(scene);
}

/// Length of the intersections on the page, hidden ones too, mm.
double intersections(const Scene& scene, Quality quality, const std::string& view = "iso") {
  PictureRequest request;
  request.lines.quality = quality;
  request.lines.hidden = HiddenLines::dashed;
  request.view.named_view = view;
  RunReport run;
  PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  const SceneStudy found = study(prepared, std::nullopt, false, run);
  const StrokeModel& model = *found.result.strokes;
  double sum = 0;
  for (const Stroke& s : model.strokes) {
    if (s.line_class == LineClass::intersection)
      sum += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  }
  return sum;
}

TEST(Contacts, ChordErrorIsTheHeightOfTheArc) {
  for (const int n : {12, 24, 48, 96}) {
    Scene scene;
    add_tube(scene, n, 10, {0, 0, 0}, {0, 0, 30}, 0.1);
    const ChordErrors errors(scene, {0, 3}, 40);
    const double height = 10 * (1 - std::cos(std::numbers::pi / n));
    EXPECT_NEAR(errors.of(0), height, 1e-6 * height);
    EXPECT_NEAR(errors.of(3), height, 1e-6 * height);
    EXPECT_EQ(ChordErrors(scene, {0}, 360.0 / n - 1).of(0), 0) << "creases are no part of a smooth surface";
  }
}

TEST(Contacts, APinInItsBoreHasNoIntersections) {
  Scene scene;
  add_tube(scene, 24, 10, {0, 0, 0}, {0, 0, 30}, 0);
  add_tube(scene, 31, 10, {0, 0, -5}, {0, 0, 40}, 0.05);
  EXPECT_GT(intersections(scene, Quality::exact), 500);
  EXPECT_EQ(intersections(scene, Quality::clear), 0);
}

/// Where tubes of one radius cross at a right angle they are tangent at two points: the line goes on there.
TEST(Contacts, CrossingTubesKeepTheirWholeLine) {
  for (const double radius : {10.0, 8.0}) {
    Scene scene;
    add_tube(scene, 36, 10, {0, 0, -30}, {0, 0, 60}, 0.03);
    add_tube(scene, 36, radius, {-30, 0, 0}, {60, 0, 0}, 0.02);
    const double exact = intersections(scene, Quality::exact);
    EXPECT_GT(exact, 100);
    EXPECT_DOUBLE_EQ(intersections(scene, Quality::clear), exact) << radius;
  }
}

TEST(Contacts, AFlatFaceThatCutsATubeIsNoContact) {
  Scene scene;
  add_tube(scene, 36, 10, {0, 0, -30}, {0, 0, 60}, 0);
  test::add_face(scene, {{{-20, -20, 1}, {20, -20, 3}, {20, 20, 2}, {-20, 20, 0}}});
  const double exact = intersections(scene, Quality::exact);
  EXPECT_GT(exact, 50);
  EXPECT_DOUBLE_EQ(intersections(scene, Quality::clear), exact);
}

}  // namespace
}  // namespace ligne
