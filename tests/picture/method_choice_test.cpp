// The choice of auto: always something, never a method for which the scene is not made, and equal lines.

#include "picture/choice/method_choice.hpp"
#include "picture/scene_visibility.hpp"
#include "report/stroke_difference.hpp"
#include "scene/clean/clean.hpp"
#include "support/corpus_scene.hpp"
#include "support/round_bodies.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

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

const Point3 kObliqueView{-0.37, 0.83, -0.41};

TEST(MethodChoice, IsNeverBeyondItsMethod) {
  std::size_t scenes = 0;
  for (const std::filesystem::path& file : corpus_files()) {
    const Scene scene = scene_of_file(file);
    for (const Point3& direction : {kObliqueView, Point3{0, 0, -1}}) {
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
  Warnings warnings;
  finish_scene(scene, warnings);
  return scene;
}

TEST(MethodChoice, TakesCullingForAConvexBody) {
  const Studied s = studied(dented_ball(48, 0, 0), kObliqueView);
  EXPECT_EQ(s.by_choice.method->traits().name, "culling");
  EXPECT_EQ(s.by_choice.why, "rule 3: one opaque convex body of many faces");
  EXPECT_LT(s.difference.length_mm, kSameLineMm);
}

TEST(MethodChoice, SeesThroughGlass) {
  const Scene scene = scene_of_file(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus/cube_in_glass.json");
  const Studied s = studied(scene, kObliqueView);
  EXPECT_EQ(s.by_choice.why, "rule 2: some faces are transparent");
  const auto behind = [](const Stroke& stroke) { return stroke.level > 0; };
  EXPECT_TRUE(std::ranges::any_of(s.by_choice.result.strokes->strokes, behind));
}

TEST(MethodChoice, TakesTheDefaultForOthers) {
  const auto name = [](const Scene& scene) { return studied(scene, kObliqueView).by_choice.method->traits().name; };
  EXPECT_EQ(name(dented_ball(8, 0, 0)), "appel") << "small";
  EXPECT_EQ(name(dented_ball(48, 0, 0, true)), "appel") << "open";
  EXPECT_EQ(name(dented_ball(48, 0.2, 24)), "appel") << "half a ring of dents";
  Scene two = dented_ball(48, 0, 0);
  add_box(two, {3, 0, 0}, {1, 1, 1});
  Warnings warnings;
  finish_scene(two, warnings);
  EXPECT_EQ(name(two), "appel") << "two bodies";
}

TEST(MethodChoice, FindsADentThatItsSampleMisses) {
  std::set<std::string> whys;
  for (std::uint32_t n = 40; n < 64; n += 2) {
    const Studied s = studied(dented_ball(n, 0.01, 1), kObliqueView);
    EXPECT_EQ(s.by_choice.method->traits().name, "appel") << n;
    whys.insert(s.by_choice.why);
  }
  EXPECT_TRUE(whys.contains("rule 4: any other scene (culling found that it is not convex)")) << *whys.begin();
}

}  // namespace
}  // namespace ligne::test
