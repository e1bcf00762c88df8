/// Traits of scenes, and the method that is chosen by them.

#include <chrono>

#include "picture/choice/method_choice.hpp"
#include "picture/choice/scene_traits.hpp"
#include "picture/scene_visibility.hpp"
#include "report/stroke_difference.hpp"
#include "support/corpus_scene.hpp"
#include "support/round_bodies.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

// Traits of large scenes, and bounds of the counts. Small ones, counted by hand: cli/scripts/traits.txt.

SceneTraits traits_of(Scene& scene, const Point3& direction) {
  finish(scene);
  const Topology topology = build_topology(scene);
  const View view = view_on_a4(scene, along(direction));
  return scene_traits(scene, topology, project(scene, topology, view, {classes("all"), 30}), scene.up_axis);
}

const Point3 kOblique{-0.37, 0.83, -0.41};
const Point3 kDown{0, 0, -1};

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

// The choice of auto: always something, never a method for which the scene is not made, and equal lines.

TEST(MethodChoice, RulesAreTotal) {
  for (unsigned bits = 0; bits < 16; ++bits) {
    const ChoiceFacts facts{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    const std::size_t rule = choose_rule(facts);
    ASSERT_LT(rule, choice_rules().size());
    const Method* method = find_method(choice_rules()[rule].method);
    ASSERT_NE(method, nullptr);
    EXPECT_TRUE(method->traits().exact);
    EXPECT_TRUE(method->traits().products & (facts.regions ? kRegions : kStrokes));
    // A method for some scenes only is taken where the scene may be one of them.
    EXPECT_TRUE(method->traits().only_for.empty() || facts.may_be_one_body);
    EXPECT_TRUE(!facts.has_transparency || method->traits().transparency == TransparencyMode::seen_through);
  }
}

TEST(MethodChoice, TheLastRuleIsForEveryScene) {
  const ChoiceRule& last = choice_rules().back();
  EXPECT_TRUE(last.holds({}));
  const MethodTraits& traits = find_method(last.method)->traits();
  EXPECT_TRUE(traits.exact && traits.penetration && traits.only_for.empty());
  EXPECT_EQ(&find_method(last.method)->traits(), &default_method().traits());
}

/// The drawings of a scene by auto and by the default method.
struct Studied {
  ChosenStudy by_choice;
  StrokeDifference difference;
};

Studied studied(const Scene& scene, const Point3& direction) {
  const ProjectedScene projected = project_on_a4(scene, along(direction));
  VisibilityOptions options;
  options.wanted = kStrokes;
  Studied result{study_by_choice(ligne::PictureRequest{}, projected, options), {}};
  result.difference =
      difference_of(*result.by_choice.result.strokes, *default_method().compute_visibility(projected, options).strokes);
  return result;
}

TEST(MethodChoice, IsNeverBeyondItsMethod) {
  std::size_t scenes = 0;
  for (const std::filesystem::path& file : corpus_files()) {
    const Scene scene = scene_of_file(file);
    for (const Point3& direction : {kOblique, Point3{0, 0, -1}}) {
      const Studied s = studied(scene, direction);
      EXPECT_EQ(s.by_choice.result.unsupported_reason, "") << file.stem();
      // The default method draws transparent faces as opaque.
      const bool has_transparency = std::ranges::any_of(scene.materials, [](const Material& m) { return m.opacity < 1; });
      EXPECT_TRUE(has_transparency || s.difference.length_mm < kSameLineMm) << file.stem();
      ++scenes;
    }
  }
  EXPECT_GT(scenes, 100u);
}

/// A ball of n meridians whose corners lie in the radius, those of a dent farther in.
Scene dented_ball(std::uint32_t n, double dent, std::uint32_t dents, bool open = false) {
  const std::uint32_t rings = n / 2 - 1;
  Scene scene = ball(
      n, rings, [&](std::uint32_t ring, std::uint32_t i) { return ring == rings / 2 && i < dents ? 1 - dent : 1; }, open);
  finish(scene);
  return scene;
}

TEST(MethodChoice, TakesCullingForAConvexBody) {
  const Studied s = studied(dented_ball(48, 0, 0), kOblique);
  EXPECT_EQ(s.by_choice.method->traits().name, "culling");
  EXPECT_EQ(s.by_choice.why, "rule 3: one opaque convex body of many faces");
  EXPECT_LT(s.difference.length_mm, kSameLineMm);
}

TEST(MethodChoice, TakesTheDefaultForOthers) {
  const auto name = [](const Scene& scene) { return studied(scene, kOblique).by_choice.method->traits().name; };
  EXPECT_EQ(name(dented_ball(8, 0, 0)), "appel") << "small";
  EXPECT_EQ(name(dented_ball(48, 0, 0, true)), "appel") << "open";
  EXPECT_EQ(name(dented_ball(48, 0.2, 24)), "appel") << "half a ring of dents";
  Scene two = dented_ball(48, 0, 0);
  add_box(two, {3, 0, 0}, {1, 1, 1});
  finish(two);
  EXPECT_EQ(name(two), "appel") << "two bodies";
}

TEST(MethodChoice, FindsADentThatItsSampleMisses) {
  std::set<std::string> whys;
  for (std::uint32_t n = 40; n < 64; n += 2) {
    const Studied s = studied(dented_ball(n, 0.01, 1), kOblique);
    EXPECT_EQ(s.by_choice.method->traits().name, "appel") << n;
    whys.insert(s.by_choice.why);
  }
  EXPECT_TRUE(whys.contains("rule 4: any other scene (culling found that it is not convex)")) << *whys.begin();
}

}  // namespace
}  // namespace ligne::test
