// Scan conversion: parity at every vertex, holes, horizontal edges, accumulators.

#include "visibility/raster/scan_conversion.hpp"
#include "support/scenes.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/raster/convex_filler.hpp"
#include "visibility/watkins/exact/crossing_queue.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne {
namespace {

const PolygonRun* run_on(const std::vector<PolygonRun>& runs, std::uint32_t line, int which = 0) {
  for (const PolygonRun& r : runs)
    if (r.line == line && which-- == 0) return &r;
  return nullptr;
}

/// Vertices exactly on lines: a peak up, a peak down, a bend, a horizontal step.
TEST(ScanConversion, VerticesOnLines) {
  const std::vector<GridPoint> points{{0, 0, 0}, {4, 4, 0}, {8, 0, 0}, {8, 6, 0}, {6, 6, 0}, {6, 8, 0}, {0, 8, 0}};
  const std::vector<std::uint32_t> end{7};
  const auto runs = scan_polygon(points, end, 20);
  EXPECT_EQ(run_on(runs, 0)->u1, 0);  // the peaks at the top have length zero, and are there
  EXPECT_EQ(run_on(runs, 2, 0)->u1, 2);
  EXPECT_EQ(run_on(runs, 2, 1)->u0, 6);
  EXPECT_EQ(run_on(runs, 4, 0)->u1 - run_on(runs, 4, 0)->u0, 8);  // the valley closes
  EXPECT_EQ(run_on(runs, 7, 0)->u1, 6);
  EXPECT_EQ(run_on(runs, 8), nullptr);
}

/// Figure 2.38: an edge that moves by less than half a unit a line. Its whole place is rounded from a real one, and so it
/// does move.
TEST(ScanConversion, SteepEdgeMovesThoughEachStepIsBelowHalf) {
  EdgeTrack t = EdgeTrack::between({10, 0, 0}, {40, 100, 50}, 200);
  for (int line = 0; line < 100; ++line, t.advance()) {
    ASSERT_NEAR(t.u, 10 + 0.3 * line, 1e-12);
    ASSERT_NEAR(t.z, 0.5 * line, 1e-12);
    ASSERT_NEAR(t.u, EdgeTrack::between({10, 0, 0}, {40, 100, 50}, 200).on(static_cast<std::uint32_t>(line)).u, 1e-11);
  }
  double frozen = 10;
  for (int line = 0; line < 100; ++line) frozen = std::floor(frozen + 0.3 + 0.5);
  EXPECT_EQ(frozen, 10);
}

/// The accumulators stay true over thousands of lines.
TEST(ScanConversion, AccumulatorsDoNotDrift) {
  EdgeTrack t = EdgeTrack::between({1.1, 0.3, 7.7}, {9876.5, 32767.9, -1}, 40000);
  for (std::uint32_t line = t.first; line < t.last; ++line, t.advance()) {
    const double share = (line - 0.3) / (32767.9 - 0.3);
    ASSERT_NEAR(t.u, 1.1 + share * (9876.5 - 1.1), 1e-7);
  }
}

// Filling in fixed point. What it paints: zbuffer_test.cpp.

struct Row {
  std::int64_t line, from, to;
  friend bool operator==(const Row&, const Row&) = default;
};

std::vector<Row> rows_of(const std::vector<std::array<double, 2>>& corners, std::int64_t first = 0,
                         std::int64_t end = 1000) {
  std::vector<FixedCorner> fixed;
  for (const auto& [u, v] : corners) fixed.push_back(FixedCorner::at(u, v));
  std::vector<Row> rows;
  ConvexFiller filler;
  filler.fill(fixed, first, end, [&](std::int64_t line, std::int64_t from, std::int64_t to) {
    if (from < to) rows.push_back({line, from, to});
  });
  return rows;
}

/// The largest places and the flattest side.
TEST(ConvexFiller, NothingOverflows) {
  const std::vector<Row> rows = rows_of({{-30000, 0.99999}, {30000, 1.00002}, {30000, 2.5}, {-30000, 2.5}}, 0, 32000);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1], (Row{2, -30000, 30000}));
  EXPECT_GE(rows[0].from, -30000);
  EXPECT_LE(rows[0].to, 30000);
}

// The promises of the studies to each other are asserted: a planted breach ends the program.

using namespace ligne::test;

#ifdef NDEBUG
#error "the tests are built with assertions"
#endif

class Invariants : public testing::Test {
 protected:
  // Other threads may be at work.
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(Invariants, PartsOfALineAscend) {
  using Parts = std::vector<LinePart>;
  EXPECT_TRUE(are_ascending(Parts{}));
  EXPECT_TRUE(are_ascending(Parts{{0, 0.5, 0}, {0.5, 1, 1}}));
  EXPECT_FALSE(are_ascending(Parts{{0, 0.5, 0}, {0.4, 1, 0}}));
  EXPECT_FALSE(are_ascending(Parts{{0.5, 1, 0}, {0, 0.5, 0}}));
  EXPECT_FALSE(are_ascending(Parts{{0.5, 0.5, 0}}));

  Scene scene;
  add_face(scene, {{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}}});
  finish(scene);
  const ProjectedScene projected = project_on_a4(scene, along({0, 1, 0}));
  const Facets facets = make_facets(projected, 1);
  const auto add = [&](const Parts& found) {
    LineStrokes strokes(projected, facets, false, 1);
    strokes.add_edges([&]() -> LineVisibility {
      return [&found](std::size_t, const PageLine&, Parts& parts) {
        parts = found;
        return false;
      };
    });
    return strokes.take().strokes.size();
  };
  EXPECT_EQ(add({{0, 0.25, 0}, {0.5, 1, 0}}), 6u);
  EXPECT_DEATH(add({{0.5, 1, 0}, {0, 0.25, 0}}), "are_ascending");
}

TEST_F(Invariants, APieceIsCutByAPlaneThatPassesThroughIt) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  ModelPieces pieces(scene);
  EXPECT_EQ(pieces.cut(0, {{1, 0, 0}, {1, 0, 0}}), 1u);
  EXPECT_DEATH(pieces.cut(0, {{1, 0, 0}, {-1, 0, 0}}), "PlaneSide::both");
}

}  // namespace
}  // namespace ligne
