// Windows and the module of analysis of the method warnock.

#include "main/script.hpp"
#include "support/test.hpp"
#include "visibility/warnock_tools.hpp"

namespace ligne::test {
namespace {

using namespace warnock;

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

}  // namespace
}  // namespace ligne::test
