// The experiments on the study of polygons: counts that are known, and relations between them.

#include "studies/experiments.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

Result result_of(std::string_view name) { return find_experiment(name)->run({StudySize::small, {}}); }

/// 3.2.3.4: the same clips take fewer signs. Triangles of a ball and bars of a ring are convex, combs are not.
TEST(StudyClips, ConvexContoursTakeFewerSigns) {
  const Result result = result_of("convex-clip");
  EXPECT_EQ(result.finding, Finding::holds);
  const Table &signs = result.tables[0], &kept = result.tables[1];
  ASSERT_EQ(signs.rows.size(), kept.rows.size());
  for (std::size_t row = 0; row < signs.rows.size(); ++row) {
    EXPECT_LE(count_in(signs, row, "signs, convex"), count_in(signs, row, "signs, any"));
    EXPECT_LE(count_in(kept, row, "apart") + count_in(kept, row, "within"), count_in(kept, row, "pairs"));
    EXPECT_LE(count_in(kept, row, "of them convex"), count_in(kept, row, "parts outside"));
  }
  constexpr std::size_t kRing = 0, kCombs = 1;
  // Nine bars: each side that passes over another bar cuts off parts that stay convex.
  EXPECT_EQ(count_in(kept, kRing, "parts outside"), 24u);
  EXPECT_EQ(count_in(kept, kRing, "of them convex"), 24u);
  EXPECT_EQ(count_in(kept, kCombs, "pairs"), 0u);
  EXPECT_EQ(count_in(signs, kCombs, "signs, convex"), count_in(signs, kCombs, "signs, any"));
}

/// 2.4.3.2: four bars and four angles, each before a copy, are four zones by the test that tells them apart.
TEST(StudyClips, CostlierTestsSpareClips) {
  const Result result = result_of("zone-tests");
  EXPECT_EQ(result.finding, Finding::holds);
  const Table& table = result.tables[0];
  constexpr std::size_t kTests = 4;
  ASSERT_EQ(table.rows.size() % kTests, 0u);
  const std::uint64_t zones[] = {1, 4, 4, 4, 1, 1, 1, 4};
  for (std::size_t row = 0; row < std::size(zones); ++row) {
    EXPECT_EQ(count_in(table, row, "zones"), zones[row]) << row;
    if (zones[row] == 4) {
      EXPECT_EQ(count_in(table, row, "clips"), 4u) << row;
    }
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::size_t boxes = row - row % kTests;
    if (row == boxes) {
      EXPECT_EQ(count_in(table, row, "pairs tested for zones") + count_in(table, row, "signs of tests"), 0u);
    } else {
      EXPECT_LE(count_in(table, row, "clips"), count_in(table, row - 1, "clips"));
    }
    // No test spares a clip that finds something.
    EXPECT_EQ(count_in(table, row, "clips") - count_in(table, row, "clips in vain"),
              count_in(table, boxes, "clips") - count_in(table, boxes, "clips in vain"));
  }
}

/// 2.4.2.4: a ring of nine bars is a ring of wrong sorts, and each exchange clips the list again; combs in a stair are
/// sorted rightly.
TEST(StudyClips, ClipFacesAreGivenUpAtOnce) {
  const Result result = result_of("inside-at-once");
  EXPECT_EQ(result.finding, Finding::in_part);
  const Table& table = result.tables[0];
  ASSERT_EQ(table.rows.size() % 2, 0u);
  for (std::size_t row = 0; row < table.rows.size(); row += 2) {
    EXPECT_EQ(count_in(table, row, "given up at once"), 0u);
    EXPECT_LE(count_in(table, row + 1, "given up at once"), count_in(table, row + 1, "wrong sorts"));
    EXPECT_LE(count_in(table, row + 1, "deepest"), count_in(table, row, "deepest"));
  }
  constexpr std::size_t kRing = 0, kCombs = 2;
  EXPECT_EQ(count_in(table, kRing + 1, "given up at once"), 8u);
  EXPECT_GT(count_in(table, kRing + 1, "clips"), count_in(table, kRing, "clips"));
  EXPECT_EQ(count_in(table, kCombs + 1, "given up at once"), 0u);
  EXPECT_EQ(count_in(table, kCombs + 1, "signs"), count_in(table, kCombs, "signs"));
}

}  // namespace
}  // namespace ligne::studies
