// The promises of the studies to each other are asserted: a planted breach ends the program.

#include "support/scenes.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/watkins/exact/crossing_queue.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne {
namespace {

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
