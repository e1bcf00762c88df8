/// The modules of the method warnock: windows and their analysis, and control; windows in any direction.

#include "base/parallel.hpp"
#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "studies/scenes/generators.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
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

/// "SPLIT LIMIT U0 U1 V0 V1: FACES": where the window is divided.
std::string divided(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text.substr(0, text.find(':')));
  const auto number = [&](std::size_t i) { return std::stod(words.at(i)); };
  Rules rules;
  rules.split = words.at(0) == "vertex" ? SplitChoice::vertex : words[0] == "side" ? SplitChoice::side : rules.split;
  rules.limit = number(1);
  const Window window{number(2), number(3), number(4), number(5)};
  Stage stage(text.substr(text.find(':') + 2));
  AnalysisCounts counts;
  const Division d = divide(stage.table(), Analysis(stage.table(), 1, true).begin(window, counts), window, rules);
  return (d.across ? "u " + as_text(d.u) : "") + (d.across && d.down ? " " : "") + (d.down ? "v " + as_text(d.v) : "");
}

/// "U,V U,V": whether the segment meets the window from 0 to 10.
std::string met(const std::string& text) {
  FramePoint a, b;
  EXPECT_EQ(std::sscanf(text.c_str(), "%lf,%lf %lf,%lf", &a.u, &a.v, &b.u, &b.v), 4);
  return meets(a, b, {0, 10, 0, 10}) ? "yes" : "no";
}

/// The functions of values/warnock.txt: of faces in words.
TextFunctions window_functions() {
  TextFunctions functions{
      {"understood",
       [](auto& t) { return kUnderstood.at(static_cast<std::size_t>(understand(StudiedWindow(t).situation))); }},
      {"divided", divided},
      {"meets", met},
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
  EXPECT_TRUE(bytes_of(one) == bytes_of(four));
  EXPECT_EQ(one.debug, four.debug);
  EXPECT_EQ(one.statistics.counts, four.statistics.counts);
}

// Windows with borders in any direction.

double area(const ConvexWindow& w) {
  double twice = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const FramePoint a = w.corner(i), b = w.corner((i + 1) % w.size());
    twice += a.u * b.v - a.v * b.u;
  }
  return twice / 2;
}

TEST(WarnockPolygon, DividedAlongTheSideThatStandsInTheWay) {
  Stage stage("face -900,-800,1 -100,-600,1 -500,-100,1; rectangle -600 -600 -200 -200 2");
  const FaceTable& table = stage.table();
  AnalysisCounts counts;
  const Analysis analysis(table, 1, true);
  const Window whole{-1000, 1000, -1000, 1000};
  const ConvexWindow window(whole);
  const auto border = [&](const ConvexWindow& w, const std::vector<Element>& elements, double limit) {
    Lists lists;
    lists.elements = elements;
    return dividing_border(table, lists, w, w.shrunk(1), 1, limit);
  };
  const std::vector<Element> elements = analysis.begin(whole, counts).elements;
  const std::optional<Border> side = border(window, elements, 0);
  ASSERT_TRUE(side);
  EXPECT_EQ(side->side({-900, -800}), 0) << "of the nearer face the side that passes nearest to the middle";
  EXPECT_EQ(side->side({-500, -100}), 0);
  // Inside that side the other two divide, then none of the face does.
  ConvexWindow rest = window;
  for (int i = 0; i < 3; ++i) {
    const std::optional<Border> next = border(rest, {elements.front()}, 0);
    ASSERT_TRUE(next);
    rest = rest.part(next->side({-500, -500}) > 0 ? *next : next->opposite());
  }
  EXPECT_NEAR(area(rest), 240000, 1e-6) << "the triangle itself";
  EXPECT_NEAR(border(rest, {elements.front()}, 0)->distance({-500, -450}), 0, 1) << "across the middle of its box";
  EXPECT_FALSE(border(window, elements, 2000)) << "at the limit of resolution";
}

/// Windows studied at a limit of resolution of 1024.
std::uint64_t windows_of(const ProjectedScene& projected, unsigned split) {
  VisibilityOptions options;
  options.wanted = kStrokes;
  options.settings.set("warnock-split", ParameterWord{split});
  options.settings.set("resolution", 1024u);
  return count_of(find_method("warnock")->compute_visibility(projected, options).statistics, "windows studied");
}

TEST(WarnockPolygon, DivisionAlongSidesSavesWindowsInEveryView) {
  constexpr unsigned kCentre = 0, kVertex = 1, kSide = 2;
  const Scene scene = corpus_scene("thesis_2_2");
  for (const StandardView& view : standard_views(scene)) {
    const ProjectedScene projected =
        project(scene, build_topology(scene), view_on_a4(scene, view.camera), {classes("feature"), 30});
    const std::uint64_t sides = windows_of(projected, kSide);
    EXPECT_LE(sides, windows_of(projected, kVertex)) << view.name;
    EXPECT_LE(2 * sides, windows_of(projected, kCentre)) << view.name;
    if (view.name != "iso") continue;
    EXPECT_EQ(sides, 35u);
    EXPECT_EQ(windows_of(projected, kVertex), 769u);
  }
}

// Areas of the method warnock. On the corpus: atherton_weiler/regions_test.cpp.

struct Areas {
  ProjectedScene projected;
  std::vector<Region> regions;
};

Areas areas_of(const Scene& scene, const CameraRequest& camera, const MethodSettings& settings = {}) {
  Areas result{project_on_a4(scene, camera), {}};
  VisibilityOptions options;
  options.settings = settings;
  result.regions = *find_method("warnock")->compute_visibility(result.projected, options).regions;
  return result;
}

/// A plate of 4 x 3 behind a cube: what is seen of both together is the plate, seen from above.
TEST(WarnockAreas, AddUpToThePlateBehind) {
  Scene scene;
  add_face(scene, {{{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}});
  add_box(scene, {0, 0, 2}, {2, 2, 1}, rotation(0.3, 0.2, 0.4));
  add_box(scene, {1, 0, 2}, {2, 1, 1}, rotation(0.1, -0.6, 0.2));  // penetrates the other
  for (const unsigned window : {0u, 1u, 2u}) {                     // screen, bounding, principal
    for (const unsigned split : {0u, 1u}) {
      MethodSettings settings;
      settings.set("warnock-window", ParameterWord{window});
      settings.set("warnock-split", ParameterWord{split});
      const Areas areas = areas_of(scene, along({0, 0, -1}), settings);
      double total = 0;
      for (const Region& r : areas.regions) total += area_of(r);
      const double scale = areas.projected.view.scale;
      // Every corner is rounded to the lattice: half a step along the rim.
      EXPECT_NEAR(total, 48 * scale * scale, 28 * scale * areas.projected.lattice.step_mm) << window << " " << split;
      const auto of_plate =
          std::count_if(areas.regions.begin(), areas.regions.end(), [](const Region& r) { return r.face == 0; });
      EXPECT_EQ(of_plate, 1);
      EXPECT_EQ(areas.regions[0].contours.size(), 2u) << "the plate has one hole, where the boxes are";
    }
  }
}

/// A bar before a plate cuts it in two; a plate with a hole shows what is behind.
TEST(WarnockAreas, OneRegionForEachPieceWithItsHoles) {
  const Scene scene =
      scene_of_faces({{{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}, {{-1, -5, 1}, {1, -5, 1}, {1, 5, 1}, {-1, 5, 1}}});
  const Areas cut = areas_of(scene, along({0, 0, -1}));
  ASSERT_EQ(cut.regions.size(), 3u);
  EXPECT_EQ(cut.regions[0].face, 0u);
  EXPECT_EQ(cut.regions[1].face, 0u);
  EXPECT_EQ(cut.regions[2].face, 1u);
  for (const Region& r : cut.regions) {
    EXPECT_EQ(r.contours.size(), 1u);
    EXPECT_EQ(r.contours[0].size(), 4u) << "no corners but the four";
  }
}

}  // namespace
}  // namespace ligne::test
