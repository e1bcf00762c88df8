// Windows and the module of analysis of the method warnock.

#include <gtest/gtest.h>

#include <random>

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
  // The same from both ends, against the truth by fine steps.
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

TEST(WarnockFaces, ContoursHaveNoCutsAndHolesAreHoles) {
  Stage stage;
  const auto frame = stage.add_frame(1000, 400, 5);
  const auto square = stage.add_rectangle(-100, -100, 100, 100, 1);
  const FaceTable& table = stage.table();
  EXPECT_EQ(table.sides_of(stage.face(frame)).size(), 8u) << "two contours of four sides";
  EXPECT_EQ(table.sides_of(stage.face(square)).size(), 4u) << "the diagonal is no side";
  EXPECT_EQ(table.faces[table.by_depth[0]].face, square) << "the nearest face comes first";
}

TEST(WarnockAnalysis, RelationsOfAFaceWithAHole) {
  Stage stage;
  const auto number = stage.add_frame(1000, 400, 5);
  const FaceTable& table = stage.table();
  const Face& face = stage.face(number);
  AnalysisCounts counts;
  const auto relation = [&](const Window& w) {
    std::uint32_t side = 0;
    return relation_to(table, face, w, side, counts);
  };
  EXPECT_EQ(relation({-200, 200, -200, 200}), Relation::disjoint) << "in the hole";
  EXPECT_EQ(relation({500, 700, -200, 200}), Relation::surrounder) << "in the material";
  EXPECT_EQ(relation({300, 500, -200, 200}), Relation::intersector) << "over the rim of the hole";
  EXPECT_EQ(relation({900, 1500, -200, 200}), Relation::intersector);
  EXPECT_EQ(relation({1001, 1500, -200, 200}), Relation::disjoint);
  EXPECT_EQ(relation({1000, 1500, -200, 200}), Relation::intersector) << "the closed window touches the side";
  EXPECT_EQ(relation({-2000, 2000, -2000, 2000}), Relation::intersector) << "the face lies in the window";
}

TEST(WarnockAnalysis, RelationsOfAFaceThatIsNotConvex) {
  Stage stage;
  // An arrow head: the fan from its inner corner covers it.
  const auto number = stage.add({{0, 0, 1}, {1000, -1000, 1}, {0, 2000, 1}, {-1000, -1000, 1}});
  const FaceTable& table = stage.table();
  AnalysisCounts counts;
  std::uint32_t side = 0;
  EXPECT_EQ(relation_to(table, stage.face(number), {-50, 50, -600, -500}, side, counts), Relation::disjoint)
      << "in the notch";
  EXPECT_EQ(relation_to(table, stage.face(number), {-50, 50, 300, 400}, side, counts), Relation::surrounder);
}

TEST(WarnockAnalysis, RelationsHoldInTurnedWindows) {
  Stage stage;
  const auto number = stage.add_rectangle(-1000, -1000, 1000, 1000, 1);
  const FaceTable& table = stage.table({3, 4});  // 25 frame units are 5 steps
  AnalysisCounts counts;
  std::uint32_t side = 0;
  EXPECT_EQ(relation_to(table, stage.face(number), {-2500, 2500, -2500, 2500}, side, counts), Relation::surrounder);
  EXPECT_EQ(relation_to(table, stage.face(number), {3500, 4500, 3500, 4500}, side, counts), Relation::intersector);
  EXPECT_EQ(relation_to(table, stage.face(number), {5500, 6500, 5500, 6500}, side, counts), Relation::disjoint);
}

TEST(WarnockAnalysis, TheRememberedSideIsTriedFirst) {
  Stage stage;
  stage.add({{-1000, -1000, 1},
             {0, -1400, 1},
             {1000, -1000, 1},
             {1400, 0, 1},
             {1000, 1000, 1},
             {0, 1400, 1},
             {-1000, 1000, 1},
             {-1400, 0, 1}});
  const FaceTable& table = stage.table();
  const Analysis analysis(table, 1, true);
  AnalysisCounts counts;
  const Window parent{900, 1100, 900, 1100};
  const Lists lists = analysis.begin(parent, counts);
  ASSERT_EQ(lists.elements.size(), 1u);
  EXPECT_EQ(lists.elements[0].relation, Relation::intersector);
  counts = {};
  const std::array<Window, 4> windows{Window{900, 1000, 900, 1000}, Window{1000, 1100, 900, 1000},
                                      Window{900, 1000, 1000, 1100}, Window{1000, 1100, 1000, 1100}};
  const auto children = analysis.children(lists, windows, counts);
  EXPECT_GE(counts.remembered, 2u) << "a side of the parent meets one child or more: there one test is enough";
  EXPECT_LT(counts.side_tests, 8u + 8u + 8u + 8u);
  EXPECT_EQ(children[0].elements.size(), 1u);
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

}  // namespace
}  // namespace ligne::test
