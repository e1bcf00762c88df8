// Traits of scenes whose figures are counted by hand, and bounds of the counts.

#include "picture/choice/scene_traits.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "scene/clean/clean.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

SceneTraits traits_of(Scene& scene, const Point3& direction) {
  Warnings warnings;
  finish_scene(scene, warnings);
  const Topology topology = build_topology(scene);
  const View view = make_view(scene, make_camera(along(direction), scene), {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}},
                              {{0, 0}, {kPageWidth, kPageHeight}});
  return scene_traits(scene, topology, project(scene, topology, view, {classes("all"), 30}));
}

/// Seen obliquely: three faces in front of three.
const Point3 kOblique{-0.37, 0.83, -0.41};
const Point3 kDown{0, 0, -1};

TEST(SceneTraits, OfABox) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {2, 2, 2});
  const SceneTraits t = traits_of(scene, kOblique);
  EXPECT_EQ(t.faces, 6u);
  EXPECT_EQ(t.front_faces, 3u);
  EXPECT_EQ(t.transparent_faces, 0u);
  EXPECT_EQ(t.convex_objects, 1u);
  EXPECT_EQ(t.zones, 1u);
  EXPECT_EQ(t.largest_zone, 6u);
  EXPECT_TRUE(t.penetrations.complete);
  EXPECT_EQ(t.penetrations.n, 0u);
  // A ray through a convex body passes two of its faces.
  EXPECT_DOUBLE_EQ(t.mean_overlap, 2);
  EXPECT_EQ(t.most_overlap, 2u);
  EXPECT_FALSE(t.height_field);
  // Every corner is the highest or the lowest of one of its faces.
  EXPECT_EQ(t.turning_vertices, 8u);
}

TEST(SceneTraits, OfBoxesApartAndThroughEachOther) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  add_box(scene, {10, 0, 0}, {1, 1, 1});
  add_box(scene, {20, 0, 0}, {1, 1, 1});
  SceneTraits t = traits_of(scene, kOblique);
  EXPECT_EQ(t.zones, 3u);
  EXPECT_EQ(t.largest_zone, 6u);
  EXPECT_EQ(t.convex_objects, 3u);

  // A bar through the side of a box: its four long faces pass through one face on each side.
  Scene pierced;
  add_box(pierced, {0, 0, 0}, {2, 2, 2});
  add_box(pierced, {-1, 0.5, 0.5}, {4, 1, 1});
  t = traits_of(pierced, kOblique);
  EXPECT_EQ(t.zones, 1u);
  EXPECT_EQ(t.penetrations.n, 8u);
  EXPECT_EQ(t.convex_objects, 2u);
}

TEST(SceneTraits, OfPlatesOverEachOther) {
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    const double z = i;
    add_face(scene, {{{0, 0, z}, {4, 0, z}, {4, 3, z}, {0, 3, z}}});
  }
  scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
  scene.face_material = {0, 1, 1, 0};
  const SceneTraits t = traits_of(scene, kDown);
  EXPECT_EQ(t.faces, 4u);
  EXPECT_EQ(t.front_faces, 4u);
  EXPECT_EQ(t.transparent_faces, 2u);
  EXPECT_EQ(t.most_overlap, 4u);
  EXPECT_DOUBLE_EQ(t.mean_overlap, 4);
  EXPECT_EQ(t.conflicts.n, 6u) << "every pair";
  EXPECT_EQ(t.convex_objects, 0u);
  EXPECT_FALSE(t.height_field);
}

/// A grid of n x n squares, two triangles each, through f(x, y).
template <class Height>
Scene sheet(int n, Height f) {
  Scene scene;
  begin_object(scene);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) scene.vertices.push_back(f(double(i) / n, double(j) / n));
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      scene.faces.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      scene.faces.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  end_object(scene);
  return scene;
}

TEST(SceneTraits, TellAHeightField) {
  Scene hills = sheet(20, [](double x, double y) { return Point3{x, y, 0.1 * std::sin(9 * x) * std::cos(7 * y)}; });
  EXPECT_TRUE(traits_of(hills, kOblique).height_field);
  Scene curl = sheet(20, [](double x, double y) { return Point3{std::cos(5 * x), y, std::sin(5 * x)}; });
  EXPECT_FALSE(traits_of(curl, kOblique).height_field);
  // A ramp twice round: no fold anywhere, and two levels over each other.
  Scene ramp = sheet(40, [](double x, double y) {
    const double a = 12 * x;
    return Point3{(1 + y) * std::cos(a), (1 + y) * std::sin(a), x};
  });
  EXPECT_FALSE(traits_of(ramp, kOblique).height_field);
}

TEST(SceneTraits, GiveUpCountsOfCrowds) {
  Scene scene;
  // All in one place on the page, each at a depth of its own: 18 million pairs.
  constexpr int kPlates = 6000;
  for (int i = 0; i < kPlates; ++i) {
    const double z = i, w = 4 + 1e-3 * i;
    add_face(scene, {{{0, 0, z}, {w, 0, z}, {w, w, z}, {0, w, z}}});
  }
  const auto start = std::chrono::steady_clock::now();
  const SceneTraits t = traits_of(scene, kDown);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_FALSE(t.conflicts.complete);
  EXPECT_GT(t.conflicts.n, 1000u);
  EXPECT_EQ(t.most_overlap, static_cast<std::uint32_t>(kPlates));
  EXPECT_EQ(t.zones, 1u);
}

}  // namespace
}  // namespace ligne::test
