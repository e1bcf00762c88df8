// Traits of scenes whose figures are counted by hand, and bounds of the counts.

#include <chrono>

#include "picture/choice/scene_traits.hpp"
#include "scene/clean/clean.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

SceneTraits traits_of(Scene& scene, const Point3& direction) {
  Warnings warnings;
  finish_scene(scene, warnings);
  const Topology topology = build_topology(scene);
  const View view = view_on_a4(scene, along(direction));
  return scene_traits(scene, topology, project(scene, topology, view, {classes("all"), 30}));
}

/// Seen obliquely: three faces in front of three.
const Point3 kOblique{-0.37, 0.83, -0.41};
const Point3 kDown{0, 0, -1};

/// A grid of n x n squares, two triangles each, through f(x, y).
template <class Height>
Scene sheet(int n, Height f) {
  Scene scene;
  begin_object(scene);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) scene.vertices.push_back(f(double(i) / n, double(j) / n));
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
  // Its three front faces are what the picture has.
  EXPECT_EQ(t.visible_faces.n, 3u);
  EXPECT_TRUE(t.visible_faces.complete);
  EXPECT_NEAR(3 * t.mean_visible_part, t.covered_part, 0.002);
  EXPECT_EQ(t.mean_corners, 4);
  EXPECT_EQ(t.most_corners, 4u);
  EXPECT_EQ(t.nonconvex_faces, 0u);
}

// [Boulle1980] 1.2.4: of the 15 pairs of faces that are not seen edge on, the row tells the 12 of different boxes apart, the
// depth the 9 of a front and a back, and the height none.
TEST(SceneTraits, OfARowOfBoxes) {
  Scene scene;
  for (const double x : {0.0, 10.0, 20.0}) add_box(scene, {x, 0, 0}, {1, 1, 1});
  const SceneTraits t = traits_of(scene, {0, 1, 0});
  EXPECT_EQ(t.faces, 6u);
  EXPECT_EQ(t.visible_faces.n, 3u);
  EXPECT_DOUBLE_EQ(t.spread.apart[0], 12.0 / 15);
  EXPECT_DOUBLE_EQ(t.spread.apart[1], 0);
  EXPECT_DOUBLE_EQ(t.spread.apart[2], 9.0 / 15);
  EXPECT_EQ(t.spread.privileged, std::optional(0));
  EXPECT_NEAR(t.covered_part, 3.0 / 21, 0.001);
  EXPECT_NEAR(t.mean_visible_part, 1.0 / 21, 1e-6);
}

// 2.6: corners, and faces that are not convex: an L and a frame. The corner on a straight side is no dent.
TEST(SceneTraits, OfFacesOfAllShapes) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}}});
  add_face(scene, {{{3, 0, 0}, {6, 0, 0}, {6, 0, 3}, {3, 0, 3}}, {{4, 0, 1}, {4, 0, 2}, {5, 0, 2}, {5, 0, 1}}});
  add_face(scene, {{{7, 0, 0}, {8, 0, 0}, {9, 0, 0}, {9, 0, 2}, {7, 0, 2}}});
  const SceneTraits t = traits_of(scene, {0, 1, 0});
  EXPECT_EQ(t.faces, 3u);
  EXPECT_DOUBLE_EQ(t.mean_corners, (6 + 8 + 5) / 3.0);
  EXPECT_EQ(t.most_corners, 8u);
  EXPECT_EQ(t.nonconvex_faces, 2u);
}

// A face is seen through a hole beside its middle; one that the frame hides is not, and one at the back of a body is not.
TEST(SceneTraits, VisibleFaces) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}}, {{1, 0, 1}, {1, 0, 2}, {2, 0, 2}, {2, 0, 1}}});
  add_face(scene, {{{0, 3, 0}, {9, 3, 0}, {9, 3, 9}, {0, 3, 9}}});
  add_face(scene, {{{5, 2, 5}, {6, 2, 5}, {6, 2, 6}, {5, 2, 6}}});
  SceneTraits t = traits_of(scene, {0, 1, 0});
  EXPECT_EQ(t.faces, 3u);
  EXPECT_EQ(t.visible_faces.n, 2u);

  // Every triangle of a fine sheet, far more than there are points of the regular grid.
  Scene fine = sheet(400, [](double x, double y) { return Point3{x, y, 0}; });
  t = traits_of(fine, kDown);
  EXPECT_EQ(t.visible_faces.n, 320'000u);
  EXPECT_TRUE(t.visible_faces.complete);
  EXPECT_NEAR(t.covered_part, 1, 1e-9);
}

// Samples find no face that has no visible region, and few escape them.
TEST(SceneTraits, VisibleFacesHaveRegions) {
  Scene scene;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 200; ++i)
    add_box(scene, Point3{u(random), u(random), u(random)} * 9.0, {1, 1, 1}, rotation(u(random) * 3, u(random), u(random)));
  const SceneTraits t = traits_of(scene, kOblique);
  const ProjectedScene projected = project_on_a4(scene, along(kOblique));
  VisibilityOptions options;
  options.wanted = kRegions;
  const VisibilityResult result = find_method("atherton-weiler")->compute_visibility(projected, options);
  std::set<std::uint32_t> faces;
  for (const Region& region : *result.regions) faces.insert(region.face);
  EXPECT_LE(t.visible_faces.n, faces.size());
  EXPECT_GE(double(t.visible_faces.n), 0.9 * double(faces.size()));
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
  scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"is_transparent", {0.5, 0.7, 0.9}, 0.4}};
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
  // The uppermost is opaque. Depth alone tells the plates apart.
  EXPECT_EQ(t.visible_faces.n, 1u);
  EXPECT_EQ(t.spread.apart, (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(t.spread.privileged, std::optional(2));
  scene.face_material = {0, 0, 1, 1};
  EXPECT_EQ(traits_of(scene, kDown).visible_faces.n, 3u) << "two of glass, and the one below them";
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
  EXPECT_EQ(t.visible_faces.n, 1u);
  EXPECT_EQ(t.zones, 1u);
}

}  // namespace
}  // namespace ligne::test
