// Traits of large scenes, and bounds of the counts. Small ones, counted by hand: cli/scripts/traits.txt.

#include <chrono>

#include "picture/choice/scene_traits.hpp"
#include "scene/clean/clean.hpp"
#include "support/mesh_text.hpp"
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

const Point3 kOblique{-0.37, 0.83, -0.41};
const Point3 kDown{0, 0, -1};

// Every triangle of a fine sheet, far more than there are points of the regular grid.
TEST(SceneTraits, VisibleFacesOfAFineSheet) {
  Scene fine = mesh_of("grid 400 x 400 triangles: u/400; v/400; 0").scene();
  const SceneTraits t = traits_of(fine, kDown);
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

// Hills; a curl; and a ramp twice round: no fold anywhere, and two levels over each other.
TEST(SceneTraits, TellAHeightField) {
  for (const auto& [mesh, is_one] : {std::pair("grid 20 x 20 triangles: u/20; v/20; 0.1*sin(9*u/20)*cos(7*v/20)", true),
                                     {"grid 20 x 20 triangles: cos(u/4); v/20; sin(u/4)", false},
                                     {"grid 40 x 40 triangles: (1+v/40)*cos(0.3*u); (1+v/40)*sin(0.3*u); u/40", false}}) {
    Scene scene = mesh_of(mesh).scene();
    EXPECT_EQ(traits_of(scene, kOblique).height_field, is_one) << mesh;
  }
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
