#include <cmath>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

/// Of the tests' lattice steps, which are millimetres.
constexpr double kCoincidence = 2;

std::vector<Stroke> removed(std::vector<Stroke> strokes) {
  StrokeModel m = model(std::move(strokes));
  remove_coincident_strokes(m, kCoincidence);
  std::sort(m.strokes.begin(), m.strokes.end(),
            [](const Stroke& l, const Stroke& r) { return std::tie(l.source, l.t_from) < std::tie(r.source, r.t_from); });
  return std::move(m.strokes);
}

struct Expected {
  std::uint32_t source;
  LatticePoint from, to;
};
void expect(const std::vector<Stroke>& got, const std::vector<Expected>& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].source, wanted[i].source) << i;
    EXPECT_TRUE(got[i].from == wanted[i].from && got[i].to == wanted[i].to)
        << i << ": " << got[i].from.x << "," << got[i].from.y << " " << got[i].to.x << "," << got[i].to.y;
  }
}

constexpr LatticePoint a{0, 0}, b{1000, 0};

TEST(CoincidentStrokes, ClassesGoByPrecedence) {
  const LineClass order[] = {LineClass::outline, LineClass::border, LineClass::intersection, LineClass::crease,
                             LineClass::mesh};
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = i + 1; j < 5; ++j) {
      expect(removed({stroke(a, b, order[j], 0), stroke(b, a, order[i], 1)}), {{1, b, a}});
    }
  }
}

TEST(CoincidentStrokes, VisibleBeforeHidden) {
  expect(removed({hidden(stroke(a, b, LineClass::outline, 0)), stroke(a, b, LineClass::mesh, 1)}), {{1, a, b}});
}

TEST(CoincidentStrokes, NearerBeforeFarther) {
  expect(removed({at_depth(stroke(a, b, LineClass::mesh, 0), 50, 50), at_depth(stroke(a, b, LineClass::mesh, 1), 9, 9)}),
         {{1, a, b}});
}

TEST(CoincidentStrokes, DepthCountsInTheMiddleOfTheOverlap) {
  // The long one is farther on the whole, and nearer where the short one lies.
  expect(removed({at_depth(stroke(a, b, LineClass::mesh, 0), 0, 1000),
                  at_depth(stroke({100, 0}, {200, 0}, LineClass::mesh, 1), 300, 300)}),
         {{0, a, b}});
  // And the other way round.
  expect(removed({at_depth(stroke(a, b, LineClass::mesh, 0), 1000, 0),
                  at_depth(stroke({100, 0}, {200, 0}, LineClass::mesh, 1), 700, 700)}),
         {{0, a, {100, 0}}, {0, {200, 0}, b}, {1, {100, 0}, {200, 0}}});
}

TEST(CoincidentStrokes, ThenTheLowerSource) {
  expect(removed({stroke(a, b, LineClass::mesh, 7), stroke(a, b, LineClass::mesh, 3)}), {{3, a, b}});
}

TEST(CoincidentStrokes, TheLoserIsCut) {
  const auto got = removed({stroke(a, b, LineClass::mesh, 0), stroke({600, 1}, {300, -1}, LineClass::outline, 1)});
  expect(got, {{0, a, {300, -1}}, {0, {600, 1}, b}, {1, {600, 1}, {300, -1}}});
  EXPECT_NEAR(got[0].t_to, 0.3, 1e-4);
  EXPECT_NEAR(got[1].t_from, 0.6, 1e-4);
  EXPECT_EQ(got[0].t_from, 0);
  EXPECT_EQ(got[1].t_to, 1);
}

TEST(CoincidentStrokes, DepthIsInterpolated) {
  const auto got =
      removed({at_depth(stroke(a, b, LineClass::mesh, 0), 10, 110), stroke(a, {500, 0}, LineClass::outline, 1)});
  expect(got, {{0, {500, 0}, b}, {1, a, {500, 0}}});
  EXPECT_FLOAT_EQ(got[0].z_from, 60);
  EXPECT_FLOAT_EQ(got[0].z_to, 110);
}

TEST(CoincidentStrokes, ParametersFollowThePerspective) {
  // An edge from (0, 0) at distance 1 to (1000, 0) at distance 4, cut at 250 and 750 and then again.
  Stroke s = stroke(a, b, LineClass::mesh, 0);
  s.w_from = 1;
  s.w_to = 4;
  const auto page = [](double t) { return 1000 * t * 4 / ((1 - t) * 1 + t * 4); };
  for (const double fraction : {0.1, 0.25, 0.5, 0.9})
    EXPECT_NEAR(page(source_parameter(s, fraction)), 1000 * fraction, 1e-9);
  const auto got =
      removed({s, stroke({250, 0}, {400, 0}, LineClass::outline, 1), stroke({600, 0}, {750, 0}, LineClass::border, 2)});
  ASSERT_EQ(got.size(), 5u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(page(got[i].t_from), got[i].from.x, 1e-4);
    EXPECT_NEAR(page(got[i].t_to), got[i].to.x, 1e-4);
    EXPECT_NEAR(got[i].w_from, 1 + 3 * got[i].t_from, 1e-6);
    EXPECT_NEAR(got[i].w_to, 1 + 3 * got[i].t_to, 1e-6);
  }
}

TEST(CoincidentStrokes, RemnantsWithinTheToleranceVanish) {
  expect(removed({stroke(a, b, LineClass::mesh, 0), stroke({1, 0}, {999, 0}, LineClass::outline, 1)}),
         {{1, {1, 0}, {999, 0}}});
  expect(removed({stroke(a, b, LineClass::mesh, 0), stroke({3, 0}, {997, 0}, LineClass::outline, 1)}),
         {{0, a, {3, 0}}, {0, {997, 0}, b}, {1, {3, 0}, {997, 0}}});
}

TEST(CoincidentStrokes, WholeStrokesWithinTheToleranceStay) {
  expect(removed({stroke(a, {2, 0}, LineClass::mesh, 0), stroke(a, b, LineClass::outline, 1)}), {{0, a, {2, 0}}, {1, a, b}});
}

TEST(CoincidentStrokes, AWedgeStays) {
  expect(removed({stroke(a, b, LineClass::mesh, 0), stroke(a, {1000, 3}, LineClass::outline, 1)}),
         {{0, a, b}, {1, a, {1000, 3}}});
}

TEST(CoincidentStrokes, ALongStrokeUnderManyShortOnesIsAbsorbed) {
  std::vector<Stroke> strokes{stroke({0, 0}, {3000000, 1000000}, LineClass::mesh, 0)};
  std::vector<Expected> wanted;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    const int x = 300 * int(i), y = 100 * int(i);
    strokes.push_back(stroke({x, y}, {x + 300, y + 100}, LineClass::outline, i + 1));
    wanted.push_back({i + 1, {x, y}, {x + 300, y + 100}});
  }
  expect(removed(strokes), wanted);
}

TEST(CoincidentStrokes, StrokesWithoutTheFlagAreHeldAgainstFlaggedOnesOnly) {
  Stroke plain = stroke(a, b, LineClass::mesh, 0), second = stroke(a, b, LineClass::mesh, 1);
  plain.may_coincide = second.may_coincide = false;
  expect(removed({plain, second}), {{0, a, b}, {1, a, b}});
  expect(removed({plain, stroke(a, b, LineClass::outline, 1)}), {{1, a, b}});
  expect(removed({plain, hidden(stroke(a, b, LineClass::outline, 1))}), {{0, a, b}});
}

TEST(CoincidentStrokes, StrokesThatLieOnNoOtherKeepTheirOrder) {
  Stroke first = stroke(a, {400, 0}, LineClass::mesh, 5), second = stroke({400, 0}, b, LineClass::mesh, 5);
  first.t_to = second.t_from = 0.4;
  first.may_coincide = second.may_coincide = false;
  Stroke other = stroke({0, 9}, {9, 9}, LineClass::mesh, 2);
  other.may_coincide = false;
  StrokeModel m = model({second, other, first});
  remove_coincident_strokes(m, kCoincidence);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_EQ(m.strokes[0].from, second.from);
  EXPECT_EQ(m.strokes[1].from, other.from);
  EXPECT_EQ(m.strokes[2].from, first.from);
}

TEST(CoincidentStrokes, ACutMeetsTheWinnerExactlySoThatTheyJoin) {
  // Two edges one step apart, one longer: together one line, drawn in one go.
  StrokeModel m =
      model({stroke({0, 0}, {1000, 0}, LineClass::outline, 0), stroke({500, 1}, {2000, 1}, LineClass::outline, 1)});
  remove_coincident_strokes(m, kCoincidence);
  const Drawing drawing = make_drawing(m);
  ASSERT_EQ(drawing.layers.size(), 1u);
  EXPECT_EQ(drawing.layers[0].lines.size(), 1u);
}

}  // namespace
}  // namespace ligne
