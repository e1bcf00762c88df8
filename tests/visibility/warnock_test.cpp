/// The modules of the method warnock: windows and their analysis, and control.

#include "base/parallel.hpp"
#include "main/script.hpp"
#include "studies/scenes/generators.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"
#include "visibility/warnock_tools.hpp"

namespace ligne::test {
namespace {

using namespace warnock;

// Windows and the module of analysis of the method warnock.

TEST(WarnockWindow, TurnsAreExactWhereDoublesAreNot) {
  // Determinants of 2^104 that differ by one.
  const double big = 0x1p52;
  const FramePoint o{0, 0}, a{big, big - 1}, b{big - 1, big - 2};
  EXPECT_EQ(turn(o, a, b), -1) << "big (big - 2) - (big - 1)^2 = -1";
  EXPECT_EQ(turn(o, b, a), 1);
  EXPECT_EQ(turn(o, a, {2 * a.u / 2, 2 * a.v / 2}), 0);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> u(-9, 9);
  for (int i = 0; i < 1000; ++i) {
    const FramePoint p{double(u(random)), double(u(random))}, q{double(u(random)), double(u(random))},
        r{double(u(random)), double(u(random))};
    EXPECT_EQ(turn(p, q, r), turn(q, r, p));
    EXPECT_EQ(turn(p, q, r), -turn(q, p, r));
  }
}

TEST(WarnockWindow, SegmentsMeetTheClosedWindow) {
  const Window w{0, 10, 0, 10};
  EXPECT_TRUE(meets({-5, 5}, {15, 5}, w));
  EXPECT_TRUE(meets({2, 2}, {3, 3}, w)) << "inside";
  EXPECT_TRUE(meets({-5, 5}, {5, 15}, w)) << "through the corner (0, 10)";
  EXPECT_FALSE(meets({-6, 5}, {5, 16}, w)) << "past the corner";
  EXPECT_TRUE(meets({10, -5}, {10, 15}, w)) << "along the border";
  EXPECT_FALSE(meets({11, -5}, {11, 15}, w));
  EXPECT_TRUE(meets({10, 10}, {20, 20}, w)) << "ends in the corner";
  EXPECT_FALSE(meets({-3, -1}, {20, -1}, w));
  // Both ends give the same answer, against the truth by fine steps.
  std::mt19937 random(11);
  std::uniform_int_distribution<int> u(-8, 18);
  for (int i = 0; i < 2000; ++i) {
    const FramePoint p{double(u(random)), double(u(random))}, q{double(u(random)), double(u(random))};
    EXPECT_EQ(meets(p, q, w), meets(q, p, w));
    bool sampled = false;
    for (int k = 0; k <= 400; ++k) {
      const double t = k / 400.0;
      sampled = sampled || (p.u + t * (q.u - p.u) >= 0 && p.u + t * (q.u - p.u) <= 10 && p.v + t * (q.v - p.v) >= 0 &&
                            p.v + t * (q.v - p.v) <= 10);
    }
    EXPECT_TRUE(!sampled || meets(p, q, w));
  }
}

TEST(WarnockAnalysis, SurroundersAreInheritedAndWhatTheyHideIsNotStudied) {
  Stage stage;
  const auto cover = stage.add_rectangle(-10000, -10000, 10000, 10000, 1);
  const auto before = stage.add_rectangle(-10, -10, 10, 10, 0.5);
  stage.add_rectangle(-20, -20, 20, 20, 3);
  const FaceTable& table = stage.table();
  const Analysis analysis(table, 1, true);
  AnalysisCounts counts;
  const Lists lists = analysis.begin({-100, 100, -100, 100}, counts);
  ASSERT_EQ(lists.elements.size(), 2u);
  EXPECT_EQ(table.faces[lists.elements[0].face].face, before);
  EXPECT_EQ(table.faces[lists.elements[1].face].face, cover);
  EXPECT_NEAR(lists.occluder_depth, 1, 1e-3);
  EXPECT_EQ(counts.not_studied, 1u) << "the face behind";
  counts = {};
  const auto children =
      analysis.children(lists, {Window{50, 100, 50, 100}, {0, -1, 0, -1}, {0, -1, 0, -1}, {0, -1, 0, -1}}, counts);
  EXPECT_EQ(counts.inherited, 1u);
  EXPECT_EQ(counts.side_tests, 0u);
  ASSERT_EQ(children[0].elements.size(), 1u);
  EXPECT_EQ(children[0].elements[0].relation, Relation::surrounder);
  // Hidden intersections need all faces.
  EXPECT_EQ(Analysis(table, 1, false).begin({-100, 100, -100, 100}, counts).elements.size(), 3u);
}

// The module of understanding of the method warnock: each case by itself, and what must not be taken for it.

constexpr Window kWindow{-1000, 1000, -1000, 1000};

/// The situation in kWindow.
struct StudiedWindow {
  explicit StudiedWindow(const std::string& faces)
      : stage(faces),
        table(stage.table()),
        lists(Analysis(table, 1, true).begin(kWindow, analysis)),
        situation(table, lists, kWindow.grown(-1), 64, analysis, depth),
        covers(study_surrounders(situation)) {}

  std::vector<const Placed*> intersectors() const {
    const auto seen = seen_intersectors(situation, covers.front);
    return seen ? *seen : std::vector<const Placed*>{};
  }

  Stage stage;
  const FaceTable& table;
  AnalysisCounts analysis;
  DepthCounts depth;
  Lists lists;
  Situation situation;
  Covers covers;
};

/// Questions about a window, by their names in values/warnock.txt.
const std::map<std::string, bool (*)(const StudiedWindow&)> kQuestions{
    {"surrounder", [](const auto& s) { return surrounder_before_everything(s.situation, s.covers); }},
    {"penetrating", [](const auto& s) { return penetrating_surrounders_before_everything(s.situation, s.covers); }},
    {"failed", [](const auto& s) { return s.covers.failed; }},
    {"seen", [](const auto& s) { return seen_intersectors(s.situation, s.covers.front).has_value(); }},
    {"two", [](const auto& s) { return s.intersectors().size() == 2; }},
    {"single", [](const auto& s) { return single_intersector(s.intersectors()); }},
    {"line", [](const auto& s) { return seen_edges_in_one_line(s.situation, s.intersectors()); }},
    {"vertex", [](const auto& s) { return seen_edges_meet_in_one_vertex(s.situation, s.intersectors()); }},
    {"apart", [](const auto& s) { return seen_intersectors_apart(s.situation, s.intersectors()); }}};

constexpr std::array kUnderstood{"no",         "surrounder", "penetrating-surrounders", "one-line", "single-intersector",
                                 "one-vertex", "apart"};

/// The functions of values/warnock.txt: of faces in words.
TextFunctions window_functions() {
  TextFunctions functions{
      {"understood",
       [](auto& t) { return kUnderstood.at(static_cast<std::size_t>(understand(StudiedWindow(t).situation))); }},
      {"front-face", [](auto& t) { return std::to_string(StudiedWindow(t).covers.front->face->face); }}};
  for (const auto& [name, ask] : kQuestions)
    functions[name] = [ask = ask](const std::string& faces) { return ask(StudiedWindow(faces)) ? "yes" : "no"; };
  return functions;
}

[[maybe_unused]] const bool windows_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/visibility/values", window_functions());

// [Boulle1980]'s case 3: the planes change places at the corners of the window, the faces do not where the intersector is.
TEST(WarnockUnderstanding, DepthIsComparedWhereTheIntersectorIs) {
  // At x = 1000 the plane of the second is at 6.6.
  StudiedWindow s("cover 3; face -500,-500,1 -100,-500,2.5 -100,500,2.5 -500,500,1");
  ASSERT_EQ(s.intersectors().size(), 1u);
  EXPECT_EQ(s.situation.compare(*s.intersectors()[0], *s.covers.front).order, DepthOrder::first);
  EXPECT_EQ(understand(s.situation), Understood::single_intersector);
  // Where the window round the intersector is wrong too, only its contour tells: the fourth corner of its box is at 4.8.
  StudiedWindow t("cover 3; face -500,-500,1 500,-500,2.9 -500,500,2.9");
  ASSERT_EQ(t.intersectors().size(), 1u);
  EXPECT_EQ(t.situation.compare(*t.intersectors()[0], *t.covers.front).order, DepthOrder::first);
  EXPECT_GT(t.depth.clipped, 0u);
}

// The module of control of the method warnock: the first window, divisions, and the findings of [Boulle1980].

TEST(WarnockControl, WindowsOfAnyWidthAreDivided) {
  Stage stage;
  stage.add_rectangle(-100, -100, 100, 100, 1);
  const FaceTable& table = stage.table();
  Rules rules;
  const auto division = [&](const Window& w) { return divide(table, {}, w, rules); };
  EXPECT_TRUE(division({0, 100, 0, 100}).across && division({0, 100, 0, 100}).down);
  EXPECT_EQ(division({0, 100, 0, 100}).u, 50);
  EXPECT_FALSE(division({0, 1, 0, 100}).across) << "a window of width one";
  EXPECT_TRUE(division({0, 1, 0, 100}).down);
  EXPECT_FALSE(division({0, 1, 0, 1}).across || division({0, 1, 0, 1}).down);
  EXPECT_FALSE(division({0, 10, 0, 100}).across) << "a slender window is not cut along";
  rules.limit = 30;
  EXPECT_FALSE(division({0, 30, 0, 20}).across) << "at the limit";
  EXPECT_TRUE(division({0, 31, 0, 20}).across);
}

TEST(WarnockControl, DivisionAtAVertexThatStandsInTheWay) {
  Stage stage;
  stage.add({{-900, 30, 1}, {40, 20, 1}, {-900, 900, 1}});
  const FaceTable& table = stage.table();
  Rules rules;
  rules.split = SplitChoice::vertex;
  AnalysisCounts counts;
  const Analysis analysis(table, 1, true);
  const Window whole{-1000, 1000, -1000, 1000};
  const Division d = divide(table, analysis.begin(whole, counts), whole, rules);
  EXPECT_EQ(d.u, 40);
  EXPECT_EQ(d.v, 20);
  const Window between{-300, 0, -200, 100};  // only the side from (-900, 30) to (40, 20) passes
  const Division e = divide(table, analysis.begin(between, counts), between, rules);
  EXPECT_EQ(e.u, -150);
  EXPECT_NEAR(e.v, 22, 1) << "the middle of the side in the window";
}

TEST(WarnockControl, DivisionAlongASideThatRunsAsTheBordersDo) {
  Stage stage;
  stage.add({{-900, 30, 1}, {40, 20, 1}, {40, 900, 1}, {-900, 900, 1}});
  const FaceTable& table = stage.table();
  Rules rules;
  rules.split = SplitChoice::side;
  AnalysisCounts counts;
  const Analysis analysis(table, 1, true);
  const auto division = [&](const Window& w) { return divide(table, analysis.begin(w, counts), w, rules); };
  const Division across = division({-100, 100, 100, 300});
  EXPECT_TRUE(across.across && !across.down) << "the upright side alone meets the window";
  EXPECT_EQ(across.u, 40);
  const Division corner = division({-100, 1000, 800, 1000});
  EXPECT_TRUE(corner.across && corner.down);
  EXPECT_EQ(corner.u, 40);
  EXPECT_EQ(corner.v, 900);
  const Division vertex = division({-300, 30, -200, 100});
  EXPECT_TRUE(vertex.across && vertex.down) << "only the slanted side meets the window: its middle";
}

TEST(WarnockControl, SceneWithoutAnything) {
  ProjectedScene scene;
  scene.lattice.step_mm = 0x1p-17;
  for (const unsigned window : {0u, 1u, 2u}) {
    VisibilityOptions options;
    options.settings.set("warnock-window", ParameterWord{window});
    options.settings.set("show", ParameterWord{0});
    const VisibilityResult result = find_method("warnock")->compute_visibility(scene, options);
    EXPECT_TRUE(result.strokes->strokes.empty());
    EXPECT_TRUE(result.regions->empty());
    EXPECT_TRUE(result.debug.empty());
  }
}

/// Figures 2.20 to 2.23, for windows/findings.txt: the number of windows of "SHIFT_X SHIFT_Z WINDOW SPLIT [whole]", the
/// triangle shifted by so much.
std::string windows_of_square(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  const std::map<std::string, unsigned> choices{{"screen", 0},   {"bounding", 1}, {"principal", 2},
                                                {"quarters", 0}, {"vertices", 1}, {"sides", 2}};
  VisibilityOptions options;
  options.wanted = kStrokes;
  options.settings.set("warnock-window", ParameterWord{choices.at(words.at(2))});
  options.settings.set("warnock-split", ParameterWord{choices.at(words.at(3))});
  if (words.size() < 5) options.settings.set("resolution", 1024u);
  const ProjectedScene projected =
      studies::on_square_sheet(studies::square_before_triangle(std::stod(words[0]), std::stod(words[1])));
  const VisibilityResult result = find_method("warnock")->compute_visibility(projected, options);
  EXPECT_EQ(result.strokes->strokes.size(), 4u) << "the sides of the square, in one piece each";
  return std::to_string(count_of(result.statistics, "windows studied"));
}

[[maybe_unused]] const bool findings_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/visibility/windows", {{"windows", windows_of_square}});

TEST(WarnockFindings, KnowledgeAndRoughTestsSaveWindows) {
  const ProjectedScene projected = studies::on_square_sheet(studies::square_before_triangle(4, 2));
  const auto windows = [&](const char* option = nullptr, ParameterValue value = {}) {
    VisibilityOptions options;
    options.wanted = kStrokes;
    options.settings.set("resolution", 1024u);
    if (option) options.settings.set(option, value);
    const VisibilityResult result = find_method("warnock")->compute_visibility(projected, options);
    EXPECT_EQ(result.strokes->strokes.size(), 4u);
    return count_of(result.statistics, "windows studied");
  };
  constexpr ParameterWord kNothing{0}, kTwo{1}, kFour{2}, kAll{3};
  EXPECT_GT(windows("understanding", kNothing), windows("understanding", kTwo));
  EXPECT_GE(windows("understanding", kTwo), windows("understanding", kFour));
  EXPECT_EQ(windows("understanding", kAll), windows()) << "all, which is the default";
  EXPECT_LE(windows("warnock-precision", 100u), windows("warnock-precision", 1u));
}

TEST(WarnockControl, OneThreadAndManyFindTheSame) {
  const ProjectedScene projected = project_on_a4(random_boxes(600, 9, 10, {2, 2, 2}), along({-1, 2, -1}));
  const auto with_threads = [&](int n) {
    VisibilityResult result;
    run_with_threads(n, [&] {
      VisibilityOptions options;
      options.settings.set("show", ParameterWord{0});
      result = find_method("warnock")->compute_visibility(projected, options);
    });
    return result;
  };
  const VisibilityResult one = with_threads(1), four = with_threads(4);
  expect_same_strokes(*one.strokes, *four.strokes);
  EXPECT_EQ(one.debug, four.debug);
  EXPECT_EQ(one.statistics.counts, four.statistics.counts);
  ASSERT_EQ(one.regions->size(), four.regions->size());
  for (std::size_t i = 0; i < one.regions->size(); ++i) {
    EXPECT_EQ((*one.regions)[i].face, (*four.regions)[i].face);
    EXPECT_EQ((*one.regions)[i].contours, (*four.regions)[i].contours);
  }
}

}  // namespace
}  // namespace ligne::test
