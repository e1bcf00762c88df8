// The comparison must find whatever is wrong with a drawing, and nothing else.

#include "compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ligne::test {
namespace {

constexpr double kStep = 0x1p-17;  // the lattice of an A4 sheet, mm
const CompareTolerance kTolerance = tolerance_of_lattice(kStep);

PageSegment segment(Point2 from, Point2 to, LineClass line_class = LineClass::outline, bool visible = true) {
  return {from, to, 0, 0, line_class, visible, "s"};
}

/// A triangle whose lower side is a border, and a hidden crease in it.
std::vector<PageSegment> picture() {
  return {segment({10, 10}, {110, 10}, LineClass::border), segment({110, 10}, {60, 90}), segment({60, 90}, {10, 10}),
          segment({60, 90}, {60, 10}, LineClass::crease, false)};
}

std::vector<std::string> found(const std::vector<PageSegment>& drawn) { return differences(picture(), drawn, kTolerance); }

/// One message that begins with the word.
void expect_only(const std::vector<std::string>& messages, const std::string& word) {
  ASSERT_EQ(messages.size(), 1u) << testing::PrintToString(messages);
  EXPECT_EQ(messages[0].substr(0, word.size()), word);
}

TEST(Compare, ToleranceIsAFewSteps) {
  EXPECT_NEAR(kTolerance.line / kStep, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(kTolerance.end / kStep, 5 / std::sqrt(2.0), 1e-12);
  EXPECT_LT(kTolerance.end, 30e-6) << "thirty nanometres on A4";
}

TEST(Compare, FindsNothingWhereNothingIsWrong) { EXPECT_EQ(found(picture()), std::vector<std::string>{}); }

TEST(Compare, DirectionOrderAndPiecesDoNotMatter) {
  const std::vector<PageSegment> drawn = {
      segment({60, 10}, {60, 90}, LineClass::crease, false), segment({60, 10}, {110, 10}, LineClass::border),
      segment({10, 10}, {60, 10}, LineClass::border), segment({60, 90}, {110, 10}), segment({10, 10}, {60, 90})};
  EXPECT_EQ(found(drawn), std::vector<std::string>{});
  // The answer in pieces and the drawing in one.
  EXPECT_EQ(differences(drawn, picture(), kTolerance), std::vector<std::string>{});
}

TEST(Compare, PiecesOfTheAnswerMayComeInAnyOrder) {
  const std::vector<PageSegment> answer = {segment({0, 0}, {10, 20}), segment({30, 60}, {40, 80}),
                                           segment({30, 60}, {20, 40}), segment({10, 20}, {20, 40})};
  EXPECT_EQ(differences(answer, {segment({0, 0}, {40, 80})}, kTolerance), std::vector<std::string>{});
  expect_only(differences(answer, {segment({0, 0}, {35, 70})}, kTolerance), "missing");
}

TEST(Compare, RoundingIsNoDifference) {
  auto drawn = picture();
  drawn[0].from += Point2{0.5, 0.5} * kStep;
  drawn[1].to += Point2{-0.5, 0.5} * kStep;
  drawn[3].to += Point2{0, 3} * kStep;  // along the line
  EXPECT_EQ(found(drawn), std::vector<std::string>{});
}

TEST(Compare, AMissingSegmentIsFound) {
  for (std::size_t i = 0; i < picture().size(); ++i) {
    auto drawn = picture();
    drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(i));
    expect_only(found(drawn), "missing");
  }
}

TEST(Compare, AnExtraSegmentIsFound) {
  for (const PageSegment& extra : {segment({20, 20}, {30, 20}), segment({110, 10}, {120, 10}, LineClass::border),
                                   segment({60, 90}, {60.001, 90}), segment({35, 50}, {85, 50}, LineClass::mesh, false)}) {
    auto drawn = picture();
    drawn.push_back(extra);
    expect_only(found(drawn), "not expected");
  }
}

TEST(Compare, AShiftedSegmentIsFound) {
  for (std::size_t i = 0; i < picture().size(); ++i) {
    auto drawn = picture();
    for (Point2* p : {&drawn[i].from, &drawn[i].to}) *p += Point2{6, 6} * kStep;
    const auto messages = found(drawn);
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].substr(0, 12), "not expected");
    EXPECT_EQ(messages[1].substr(0, 7), "missing");
  }
}

TEST(Compare, AnEndTooFarOrTooShortIsFound) {
  auto drawn = picture();
  drawn[0].to.x -= 5 * kStep;
  expect_only(found(drawn), "missing");
  drawn[0].to.x += 10 * kStep;
  EXPECT_EQ(found(drawn).size(), 2u);
}

TEST(Compare, ATurnedSegmentIsFound) {
  auto drawn = picture();
  drawn[0].to.y += 3 * kStep;
  EXPECT_EQ(found(drawn).size(), 2u);
}

TEST(Compare, AGapIsFound) {
  auto drawn = picture();
  drawn[0].to = {50, 10};
  drawn.push_back(segment({50.0001, 10}, {110, 10}, LineClass::border));
  expect_only(found(drawn), "missing");
}

TEST(Compare, AWrongClassIsFound) {
  for (std::size_t i = 0; i < picture().size(); ++i) {
    auto drawn = picture();
    drawn[i].line_class = LineClass::mesh;
    EXPECT_EQ(found(drawn).size(), 2u);
  }
}

TEST(Compare, AWrongVisibilityIsFound) {
  for (std::size_t i = 0; i < picture().size(); ++i) {
    auto drawn = picture();
    drawn[i].visible = !drawn[i].visible;
    EXPECT_EQ(found(drawn).size(), 2u);
  }
}

TEST(Compare, AWrongDepthIsFound) {
  auto drawn = picture();
  drawn[1].z_to = 1;
  EXPECT_EQ(found(drawn).size(), 2u);
  // On a slope: right at both ends, and turned round.
  auto expected = picture();
  expected[1].z_from = -40;
  expected[1].z_to = 60;
  drawn[1].z_from = -40;
  drawn[1].z_to = 60;
  EXPECT_EQ(differences(expected, drawn, kTolerance), std::vector<std::string>{});
  std::swap(drawn[1].z_from, drawn[1].z_to);
  EXPECT_EQ(differences(expected, drawn, kTolerance).size(), 2u);
}

TEST(Compare, ALineDrawnTwiceIsFound) {
  auto drawn = picture();
  drawn.push_back(drawn[1]);
  expect_only(found(drawn), "twice");
  drawn.back() = segment({20, 10}, {20.001, 10}, LineClass::border);  // a piece of one
  expect_only(found(drawn), "twice");
}

TEST(Compare, OverlapsOfTwoClassesAreFound) {
  const std::vector<PageSegment> lines = {segment({0, 0}, {10, 5}), segment({4, 2}, {20, 10}, LineClass::crease, false)};
  expect_only(overlaps(lines, kTolerance), "twice");
}

TEST(Compare, LinesThatMeetOrCrossOrPartAreNoOverlap) {
  const std::vector<PageSegment> lines = {segment({0, 0}, {10, 0}), segment({10, 0}, {20, 0}), segment({5, -5}, {5, 5}),
                                          segment({0, 0}, {20, 0.001}), segment({0, 1}, {10, 1})};
  EXPECT_EQ(overlaps(lines, kTolerance), std::vector<std::string>{});
}

TEST(Compare, LinesAtTwoDepthsAreNotJoined) {
  // On the page one straight line, in space two.
  auto near = segment({0, 0}, {10, 0}), far = segment({10, 0}, {20, 0});
  far.z_from = far.z_to = 30;
  EXPECT_EQ(differences({near, far}, {far, near}, kTolerance), std::vector<std::string>{});
  EXPECT_EQ(differences({near, far}, {segment({0, 0}, {20, 0})}, kTolerance).size(), 3u);
}

}  // namespace
}  // namespace ligne::test
