/// Objects that repeat an earlier one, and the surfaces that they take over from it.

#include "scene/patches/repeated_objects.hpp"
#include "support/test.hpp"

#include "patches/patch_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

/// A pin: a cylinder with a cone at its end, along z.
std::vector<Corners> pin(double radius = 2) {
  std::vector<Corners> polygons;
  const double radii[] = {radius, radius, 1};
  const double heights[] = {0, 5, 8};
  add_grid(polygons, 24, 2, false, [&](int u, int v) { return on_circle(radii[v], 2 * kPi * (u % 24) / 24, heights[v]); });
  return polygons;
}

/// Turns by an angle about x and scales, then shifts.
std::vector<Corners> moved(std::vector<Corners> polygons, double angle, double scale, const Point3& shift) {
  for (Corners& polygon : polygons) {
    for (Point3& p : polygon) {
      const double y = p.y * std::cos(angle) - p.z * std::sin(angle), z = p.y * std::sin(angle) + p.z * std::cos(angle);
      p = scale * Point3(p.x, y, z) + shift;
    }
  }
  return polygons;
}

/// A scene with an object for each list of polygons.
Scene assembly(const std::vector<std::vector<Corners>>& parts) {
  Scene scene;
  for (const std::vector<Corners>& part : parts) {
    const Scene one = scene_of(part);
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    Object object = one.objects.front();
    object.vertex_begin = first;
    object.face_begin = static_cast<std::uint32_t>(scene.faces.size());
    scene.vertices.insert(scene.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (std::size_t f = 0; f < one.faces.size(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t v : one.faces.contour(f, 0)) corners.push_back(first + v);
      scene.faces.add_face(corners);
    }
    object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_end = static_cast<std::uint32_t>(scene.faces.size());
    scene.objects.push_back(object);
  }
  return scene;
}

std::vector<std::uint32_t> originals(const Scene& scene) {
  std::vector<std::uint32_t> found;
  for (const Repetition& r : find_repetitions(scene, build_topology(scene))) found.push_back(r.original);
  return found;
}

using Numbers = std::vector<std::uint32_t>;

TEST(RepeatedObjects, AreFoundWhereverTheyLie) {
  const auto original = pin();
  EXPECT_EQ(originals(assembly({original, moved(original, 0.7, 1, {9, 1, 2}), moved(original, -2, 1.5, {1, 30, 2})})),
            (Numbers{0, 0, 0}));
}

TEST(RepeatedObjects, AreNoOthers) {
  const auto original = pin();
  auto mirrored = original;
  for (Corners& polygon : mirrored) {
    for (Point3& p : polygon) p.x = -p.x;
  }
  auto dented = moved(original, 0.7, 1, {9, 1, 2});
  dented[3][0].z += 1e-4;
  EXPECT_EQ(originals(assembly({original, mirrored, dented, pin(2.001), moved(original, 1, 1, {8, 8, 8})})),
            (Numbers{0, 1, 2, 3, 0}));
}

TEST(RepeatedObjects, AreNoOthersWhereTheFileMarksEdges) {
  Scene scene = assembly({pin(), pin()});
  scene.corner_flags.assign(scene.faces.corners().size(), 0);
  scene.corner_flags.back() = kCornerSharp;
  EXPECT_EQ(originals(scene), (Numbers{0, 1}));
}

TEST(RepeatedObjects, OfACrowdAreComparedWithAFew) {
  std::vector<std::vector<Corners>> crowd;
  for (int i = 0; i < 40; ++i) crowd.push_back(pin(2 + 0.05 * i));
  for (int i = 0; i < 40; ++i) crowd.push_back(moved(pin(2 + 0.05 * i), 1, 1, {0, 20, 0}));
  const Numbers found = originals(assembly(crowd));
  for (std::uint32_t i = 0; i < 80; ++i) EXPECT_EQ(found[i], i < 40 || i >= 44 ? i : i - 40) << "four shapes are kept";
}

/// The surfaces taken over are those that a search of the copy alone finds.
TEST(RepeatedObjects, HaveTheSurfacesOfTheOriginal) {
  const auto original = pin(), copy = moved(original, 0.7, 1.5, {9, 1, 2});
  const FoundPatches both(assembly({original, copy})), alone(copy);
  ASSERT_EQ(alone.patches.list.size(), 2u);
  ASSERT_EQ(both.patches.list.size(), 4u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Patch &own = alone.patches.list[i], &taken = both.patches.list[2 + i];
    EXPECT_EQ(taken.surface.kind, own.surface.kind);
    EXPECT_EQ(taken.outward, own.outward);
    EXPECT_NEAR(taken.sag, own.sag, 1e-6);
    EXPECT_NEAR(std::abs(glm::dot(taken.surface.axis, own.surface.axis)), 1, 1e-9);
    for (const Point3& p : alone.scene.vertices) EXPECT_NEAR(taken.surface.distance(p), own.surface.distance(p), 1e-5);
  }
  const std::size_t faces = alone.scene.faces.size();
  for (std::size_t f = 0; f < faces; ++f) EXPECT_EQ(both.patches.patch_of[faces + f], 2 + alone.patches.patch_of[f]);
}

}  // namespace
}  // namespace ligne
