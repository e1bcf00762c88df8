/// Traits of scenes, and the method that is chosen by them.

#include <chrono>

#include "linework/stroke_builder.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/choice/scene_traits.hpp"
#include "picture/scene_visibility.hpp"
#include "report/compare.hpp"
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

// Drawings of two methods, and strokes that differ.

// Methods side by side: exact ones agree, what goes wrong with one is a row.

CompareRequest all() {
  CompareRequest request;
  for (const Method* method : all_methods()) request.methods.push_back({method});
  request.picture.lines.quality = Quality::exact;
  return request;
}

MethodComparison compared(const Scene& scene, const CompareRequest& request) {
  return compare_methods(scene, build_topology(scene), request);
}

TEST(Compare, ExactMethodsAgree) {
  for (const char* name : {"bricks", "cross_of_plates", "lattice_of_bars", "gear", "holes_behind_holes", "cyclic_4"}) {
    const MethodComparison c = compared(corpus_scene(name), all());
    ASSERT_EQ(c.methods.size(), all_methods().size());
    ASSERT_TRUE(c.reference);
    for (std::size_t i = 0; i < c.methods.size(); ++i) {
      const MethodOutcome& m = c.methods[i];
      EXPECT_TRUE(m.drawn()) << m.failure;
      EXPECT_GT(m.seconds(), 0);
      EXPECT_EQ(c.differences_mm[i][i], 0);
      if (m.exact() && m.unsupported_reason.empty()) {
        EXPECT_GT(m.visible_mm, 0) << name << ", " << m.method->traits().name;
        EXPECT_EQ(c.differences_mm[*c.reference][i], 0) << name << ", " << m.method->traits().name;
      }
    }
  }
}

TEST(Compare, OrdersLeaveFacesThatAreAllButEdgeOnToDepths) {
  CompareRequest request;
  for (const char* name : {"appel", "newell", "bsp", "convex-tree"}) request.methods.push_back({find_method(name)});
  request.picture.lines.quality = Quality::exact;
  const MethodComparison c = compared(corpus_scene("nearly_edge_on_iso"), request);
  for (std::size_t i = 0; i < c.methods.size(); ++i)
    EXPECT_EQ(c.differences_mm[0][i], 0) << c.methods[i].method->traits().name;
}

TEST(Compare, TellsWhatAMethodCanNot) {
  const MethodComparison c = compared(corpus_scene("cross_of_plates"), all());
  const auto of = [&](const char* name) -> const MethodOutcome& {
    return *std::find_if(c.methods.begin(), c.methods.end(),
                         [&](const MethodOutcome& m) { return m.method->traits().name == name; });
  };
  EXPECT_FALSE(of("culling").unsupported_reason.empty());
  EXPECT_GT(of("culling").from_reference.length_mm, 1);
  EXPECT_TRUE(of("zbuffer").resolution_mm);
  EXPECT_FALSE(of("appel").resolution_mm);
  EXPECT_TRUE(of("appel").operations[static_cast<std::size_t>(OperationKind::line_tests)]);
  EXPECT_FALSE(of("appel").operations[static_cast<std::size_t>(OperationKind::abscissas)]);
  // 2.6: 3 words to a vertex and 37 to a face.
  const Scene scene = corpus_scene("cross_of_plates");
  EXPECT_EQ(of("warnock").thesis_words, 3 * scene.vertices.size() + 37 * scene.faces.size());
  EXPECT_FALSE(of("appel").thesis_words);
}

TEST(Compare, OneThatTakesTooLongIsARow) {
  CompareRequest request = all();
  request.limit_seconds = 0;
  const MethodComparison c = compared(corpus_scene("lattice_of_bars"), request);
  ASSERT_EQ(c.methods.size(), all_methods().size());
  std::size_t ended = 0;
  for (const MethodOutcome& m : c.methods) ended += m.failure == "ended after 0 s";
  EXPECT_GT(ended, 0u);
}

TEST(Compare, OneThatFailsIsARow) {
  CompareRequest request;
  request.methods = {{find_method("appel")}, {find_method("zbuffer")}};
  request.methods[1].settings.set("lines", 512u);
  request.picture.regions = true;  // which the depth buffer does not have, nor does appel
  const MethodComparison c = compared(corpus_scene("cube"), request);
  ASSERT_EQ(c.methods.size(), 2u);
  for (const MethodOutcome& m : c.methods) expect_parts(m.failure, {"needs a method that gives regions"});
  EXPECT_FALSE(c.reference);
  EXPECT_FALSE(c.differences_mm[0][1]);
}

TEST(Compare, ProgressRises) {
  CompareRequest request = all();
  double last = 0;
  request.progress = [&](double fraction) {
    EXPECT_GE(fraction, last - 1e-12);
    last = fraction;
  };
  compared(corpus_scene("bricks"), request);
  EXPECT_EQ(last, 1);
}

// Parts of lines that one drawing shows and another lacks.

/// A tolerance of half a step of these lattices, which are a millimetre wide.
constexpr double kHalf = 0.5;

TEST(StrokeDifference, IsTheLengthThatOneOfThemLacks) {
  const struct {
    const char *name, *first, *second;
    double length;
  } cases[] = {{"one line in other pieces", "0,0 90,30", "30,10 0,0; 30,10 90,30", 0},
               {"hidden strokes are not drawn", "0,0 100,0", "hidden 0,0 100,0", 100},
               {"hidden strokes are not missing", "hidden 0,0 100,0", "hidden 0,0 100,0", 0},
               {"back to front", "0,0 100,30; 20,0 20,50", "20,50 20,0; 100,30 0,0", 0}};
  for (const auto& c : cases)
    EXPECT_NEAR(difference_of(sketch(c.first), sketch(c.second), kHalf).length_mm, c.length, 1e-9 * c.length) << c.name;
}

TEST(StrokeDifference, IsWhatOneOfThemLacks) {
  const StrokeDifference d =
      difference_of(sketch("0,0 100,0; 0,50 100,50"), sketch("0,0 40,0; 70,0 100,0; 0,50 120,50"), kHalf);
  ASSERT_EQ(d.only_first.size(), 1u);
  EXPECT_NEAR(d.only_first[0].from.x, 40, 1e-9);
  EXPECT_NEAR(d.only_first[0].to.x, 70, 1e-9);
  ASSERT_EQ(d.only_second.size(), 1u);
  EXPECT_NEAR(d.length_mm, 50, 1e-9);
  EXPECT_NEAR(d.longest_mm, 30, 1e-9);
}

TEST(StrokeDifference, LevelsCountWhereTheyAreAskedFor) {
  StrokeModel direct = sketch("0,0 100,0"), through = direct;
  through.strokes[0].level = 1;
  EXPECT_TRUE(parts_missing(direct, through, kHalf).empty());
  EXPECT_EQ(parts_missing(direct, through, kHalf, true).size(), 1u);
}

TEST(StrokeDifference, TheSamePointsOfAnotherLatticeAreElsewhere) {
  const StrokeModel here = sketch("0,0 100,0");
  StrokeModel elsewhere = here;
  elsewhere.lattice.origin_mm.y += 10;
  EXPECT_NEAR(difference_of(here, elsewhere, kHalf).length_mm, 200, 1e-9);
}

}  // namespace
}  // namespace ligne::test
