// The module of control of the method warnock: the first window, divisions, and the findings of [Boulle1980].

#include "base/parallel.hpp"
#include "main/script.hpp"
#include "studies/scenes/generators.hpp"
#include "support/scenes.hpp"
#include "visibility/warnock_tools.hpp"

namespace ligne::test {
namespace {

using namespace warnock;

TEST(WarnockControl, PiecesShareTheirEndsAndFindTheirChild) {
  const Division division{7, -5, true, true};
  expect_pieces_of_children(division, [&](int child, FramePoint p) {
    return (child % 2 == 1) == (p.u >= division.u) && (child / 2 == 1) == (p.v >= division.v);
  });
}

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
