// The module of understanding of the method warnock: each case by itself, and what must not be taken for it.

#include <gtest/gtest.h>

#include "visibility/warnock_tools.hpp"

namespace ligne::test {
namespace {

using namespace warnock;

constexpr Window kWindow{-1000, 1000, -1000, 1000};
constexpr std::int32_t kFar = 5000;  ///< well outside the window

/// The situation in kWindow.
struct StudiedWindow {
  explicit StudiedWindow(Stage& stage)
      : table(stage.table()),
        lists(Analysis(table, 1, true).begin(kWindow, analysis)),
        situation(table, lists, kWindow.grown(-1), 64, analysis, depth),
        covers(study_surrounders(situation)) {}

  std::vector<const Placed*> intersectors() const {
    const auto seen = seen_intersectors(situation, covers.front);
    return seen ? *seen : std::vector<const Placed*>{};
  }

  const FaceTable& table;
  AnalysisCounts analysis;
  DepthCounts depth;
  Lists lists;
  Situation situation;
  Covers covers;
};

std::uint32_t add_cover(Stage& stage, double z) { return stage.add_rectangle(-kFar, -kFar, kFar, kFar, z); }

/// A surrounder whose depth goes from `left` to `right`.
std::uint32_t add_tilted_cover(Stage& stage, double left, double right) {
  return stage.add({{-kFar, -kFar, left}, {kFar, -kFar, right}, {kFar, kFar, right}, {-kFar, kFar, left}});
}

TEST(WarnockUnderstanding, SurrounderBeforeEverything) {
  Stage stage;
  const auto front = add_tilted_cover(stage, 1, 3);
  add_tilted_cover(stage, 2, 4);                          // behind it, though their depths overlap
  stage.add({{-500, 0, 3}, {500, 0, 3.5}, {0, 500, 3}});  // behind it where it is
  StudiedWindow s(stage);
  EXPECT_TRUE(surrounder_before_everything(s.situation, s.covers));
  EXPECT_EQ(s.covers.front->face->face, front);
  EXPECT_EQ(understand(s.situation), Understood::surrounder);
}

TEST(WarnockUnderstanding, SurrounderIsNotBeforeWhatTouchesIt) {
  Stage stage;
  add_cover(stage, 1);
  stage.add_rectangle(-100, -100, 100, 100, 1);  // lies on it: its rim is drawn
  StudiedWindow s(stage);
  EXPECT_FALSE(surrounder_before_everything(s.situation, s.covers));
  EXPECT_EQ(understand(s.situation), Understood::single_intersector);
}

TEST(WarnockUnderstanding, SurrounderOfWhichTheRimRunsAlongTheWindow) {
  Stage stage;
  stage.add_rectangle(-1000, -1000, 1000, 1000, 1);  // the window itself
  stage.add({{-500, 0, 3}, {500, 0, 3.5}, {0, 500, 3}});
  StudiedWindow s(stage);
  EXPECT_TRUE(surrounder_before_everything(s.situation, s.covers));
}

TEST(WarnockUnderstanding, TwoPenetratingSurroundersBeforeEverything) {
  Stage stage;
  add_tilted_cover(stage, 1, 3);
  add_tilted_cover(stage, 3, 1);
  add_cover(stage, 4);
  stage.add({{-500, 0, 3}, {500, 0, 3.5}, {0, 500, 3}});
  StudiedWindow s(stage);
  EXPECT_FALSE(surrounder_before_everything(s.situation, s.covers));
  EXPECT_TRUE(penetrating_surrounders_before_everything(s.situation, s.covers));
  EXPECT_EQ(understand(s.situation), Understood::penetrating_surrounders);
}

TEST(WarnockUnderstanding, TwoPenetratingSurroundersWithSomethingBeforeThem) {
  Stage stage;
  add_tilted_cover(stage, 1, 3);
  add_tilted_cover(stage, 3, 1);
  stage.add({{-100, 0, 1.5}, {100, 0, 1.5}, {0, 100, 1.5}});
  StudiedWindow s(stage);
  EXPECT_FALSE(penetrating_surrounders_before_everything(s.situation, s.covers));
  EXPECT_EQ(understand(s.situation), Understood::no);
}

TEST(WarnockUnderstanding, ThreePenetratingSurroundersFail) {
  Stage stage;
  add_tilted_cover(stage, 1, 3);
  add_tilted_cover(stage, 3, 1);
  add_cover(stage, 1.99);
  StudiedWindow s(stage);
  EXPECT_TRUE(s.covers.failed);
  EXPECT_EQ(understand(s.situation), Understood::no);
}

TEST(WarnockUnderstanding, SeenEdgesInOneLine) {
  // Two faces of a solid with a common edge, and one behind the cover.
  Stage stage;
  add_cover(stage, 5);
  stage.add({{-kFar, 100, 1}, {kFar, 100, 1}, {kFar, kFar, 2}, {-kFar, kFar, 2}});
  stage.add({{-kFar, 100, 1}, {kFar, 100, 1}, {kFar, kFar, 1.5}, {-kFar, kFar, 1.5}});
  stage.add_rectangle(-100, -100, 100, 100, 6);
  StudiedWindow s(stage);
  EXPECT_EQ(s.intersectors().size(), 2u);
  EXPECT_TRUE(seen_edges_in_one_line(s.situation, s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::one_line);
}

TEST(WarnockUnderstanding, SeenEdgesInTwoLines) {
  Stage stage;
  stage.add({{-kFar, 100, 1}, {kFar, 100, 1}, {kFar, kFar, 2}, {-kFar, kFar, 2}});
  stage.add({{-kFar, 101, 1}, {kFar, 101, 1}, {kFar, kFar, 1.5}, {-kFar, kFar, 1.5}});
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_edges_in_one_line(s.situation, s.intersectors()));
}

TEST(WarnockUnderstanding, SeenEdgesInOneLineOfFacesThatCross) {
  Stage stage;
  stage.add({{-kFar, 100, 1}, {kFar, 100, 3}, {kFar, kFar, 3}, {-kFar, kFar, 1}});
  stage.add({{-kFar, 100, 3}, {kFar, 100, 1}, {kFar, kFar, 1}, {-kFar, kFar, 3}});
  StudiedWindow s(stage);
  EXPECT_EQ(s.intersectors().size(), 2u);
  EXPECT_FALSE(seen_edges_in_one_line(s.situation, s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::no);
}

TEST(WarnockUnderstanding, SingleIntersector) {
  Stage stage;
  add_cover(stage, 5);
  stage.add({{-500, 0, 3}, {500, 0, 3.5}, {0, 500, 3}});
  stage.add_rectangle(-100, -100, 100, 100, 6);  // hidden
  StudiedWindow s(stage);
  EXPECT_TRUE(single_intersector(s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::single_intersector);
}

TEST(WarnockUnderstanding, SingleIntersectorThroughTheCoverFails) {
  Stage stage;
  add_cover(stage, 3);
  stage.add({{-500, 0, 2}, {500, 0, 4}, {0, 500, 2}});
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_intersectors(s.situation, s.covers.front).has_value());
  EXPECT_EQ(understand(s.situation), Understood::no);
}

// [Boulle1980]'s case 3: the planes change places at the corners of the window, the faces do not where the intersector is.
TEST(WarnockUnderstanding, DepthIsComparedWhereTheIntersectorIs) {
  Stage stage;
  add_cover(stage, 3);
  stage.add({{-500, -500, 1}, {-100, -500, 2.5}, {-100, 500, 2.5}, {-500, 500, 1}});  // at x = 1000 its plane is at 6.6
  StudiedWindow s(stage);
  ASSERT_EQ(s.intersectors().size(), 1u);
  EXPECT_EQ(s.situation.compare(*s.intersectors()[0], *s.covers.front).order, DepthOrder::first);
  EXPECT_EQ(understand(s.situation), Understood::single_intersector);
}

// The same where the window round the intersector is wrong too: only its contour tells.
TEST(WarnockUnderstanding, DepthIsComparedOverTheContour) {
  Stage stage;
  add_cover(stage, 3);
  stage.add({{-500, -500, 1}, {500, -500, 2.9}, {-500, 500, 2.9}});  // the fourth corner of its box is at 4.8
  StudiedWindow s(stage);
  ASSERT_EQ(s.intersectors().size(), 1u);
  EXPECT_EQ(s.situation.compare(*s.intersectors()[0], *s.covers.front).order, DepthOrder::first);
  EXPECT_GT(s.depth.clipped, 0u);
}

TEST(WarnockUnderstanding, SeenEdgesMeetInOneVertex) {
  // The corner of a solid: three faces round a vertex.
  Stage stage;
  add_cover(stage, 9);
  const Corner tip{10, 20, 1};
  const Corner a{kFar, 0, 4}, b{-kFar, kFar, 4}, c{-kFar, -kFar, 4};
  stage.add({tip, a, b});
  stage.add({tip, b, c});
  stage.add({tip, c, a});
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_edges_in_one_line(s.situation, s.intersectors()));
  EXPECT_TRUE(seen_edges_meet_in_one_vertex(s.situation, s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::one_vertex);
}

TEST(WarnockUnderstanding, SeenEdgesMeetInTwoVertices) {
  Stage stage;
  stage.add({{0, 0, 1}, {kFar, 0, 4}, {-kFar, kFar, 4}});
  stage.add({{0, 1, 2}, {kFar, 1, 4}, {-kFar, kFar, 4}});
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_edges_meet_in_one_vertex(s.situation, s.intersectors()));
}

TEST(WarnockUnderstanding, SeenEdgesMeetOutsideTheWindow) {
  Stage stage;
  const Corner tip{1500, 0, 1};
  stage.add({tip, {-kFar, 100, 4}, {-kFar, 300, 4}});
  stage.add({tip, {-kFar, -100, 4}, {-kFar, -300, 4}});
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_edges_meet_in_one_vertex(s.situation, s.intersectors()));
}

TEST(WarnockUnderstanding, SeenIntersectorsApart) {
  Stage stage;
  add_cover(stage, 9);
  stage.add_rectangle(-500, -500, -100, 500, 1);
  stage.add_rectangle(100, -300, 400, 500, 2);
  stage.add_rectangle(400, -300, 600, 500, 3);  // beside it, with a common side
  StudiedWindow s(stage);
  EXPECT_TRUE(seen_intersectors_apart(s.situation, s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::apart);
}

TEST(WarnockUnderstanding, SeenIntersectorsOverEachOther) {
  Stage stage;
  stage.add_rectangle(-500, -500, 101, 500, 1);
  stage.add_rectangle(100, -300, 400, 500, 2);
  StudiedWindow s(stage);
  EXPECT_FALSE(seen_intersectors_apart(s.situation, s.intersectors()));
  EXPECT_EQ(understand(s.situation), Understood::no);
}

}  // namespace
}  // namespace ligne::test
