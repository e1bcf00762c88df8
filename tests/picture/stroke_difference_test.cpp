/// Parts of lines that one drawing shows and another lacks.

#include "report/stroke_difference.hpp"
#include "linework/stroke_builder.hpp"

namespace ligne {
namespace {

/// A tolerance of half a step of these lattices, which are a millimetre wide.
constexpr double kHalf = 0.5;

TEST(StrokeDifference, IsTheLengthThatOneOfThemLacks) {
  const struct {
    const char *name, *first, *second;
    double length;
  } cases[] = {{"one line in other pieces", "0,0 90,30", "30,10 0,0; 30,10 90,30", 0},
               {"hidden strokes are not drawn", "0,0 100,0", "hidden 0,0 100,0", 100},
               {"hidden strokes are not missing", "hidden 0,0 100,0", "hidden 0,0 100,0", 0},
               {"back to front", "0,0 100,30; 20,0 20,50", "20,50 20,0; 100,30 0,0", 0}};
  for (const auto& c : cases)
    EXPECT_NEAR(difference_of(sketch(c.first), sketch(c.second), kHalf).length_mm, c.length, 1e-9 * c.length) << c.name;
}

TEST(StrokeDifference, IsWhatOneOfThemLacks) {
  const StrokeDifference d =
      difference_of(sketch("0,0 100,0; 0,50 100,50"), sketch("0,0 40,0; 70,0 100,0; 0,50 120,50"), kHalf);
  ASSERT_EQ(d.only_first.size(), 1u);
  EXPECT_NEAR(d.only_first[0].from.x, 40, 1e-9);
  EXPECT_NEAR(d.only_first[0].to.x, 70, 1e-9);
  ASSERT_EQ(d.only_second.size(), 1u);
  EXPECT_NEAR(d.length_mm, 50, 1e-9);
  EXPECT_NEAR(d.longest_mm, 30, 1e-9);
}

TEST(StrokeDifference, LevelsCountWhereTheyAreAskedFor) {
  StrokeModel direct = sketch("0,0 100,0"), through = direct;
  through.strokes[0].level = 1;
  EXPECT_TRUE(parts_missing(direct, through, kHalf).empty());
  EXPECT_EQ(parts_missing(direct, through, kHalf, true).size(), 1u);
}

TEST(StrokeDifference, TheSamePointsOfAnotherLatticeAreElsewhere) {
  const StrokeModel here = sketch("0,0 100,0");
  StrokeModel elsewhere = here;
  elsewhere.lattice.origin_mm.y += 10;
  EXPECT_NEAR(difference_of(here, elsewhere, kHalf).length_mm, 200, 1e-9);
}

}  // namespace
}  // namespace ligne
