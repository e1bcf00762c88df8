// The experiments on scans by lines as their source describes them: relations between their counts.

#include "studies/experiments.hpp"
#include "studies/scenes/generators.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

Result run_small(std::string_view name) { return find_experiment(name)->run({StudySize::small, {}}); }

/// Twice the lines miss less of the exact strokes, and an end on the next line adds what one on the last does not.
TEST(StudyTracking, FinerLinesMissLess) {
  const Table table = run_small("tracking").tables[0];
  ASSERT_EQ(table.rows.size() % 3, 0u);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_GT(number_in(table, row, "missing"), 0);
    EXPECT_LT(number_in(table, row, "missing"), number_in(table, row, "exact"));
    EXPECT_GE(number_in(table, row, "added, to the next line"), number_in(table, row, "added, to the last line"));
    if (row % 3 > 0) {
      EXPECT_LT(number_in(table, row, "missing"), number_in(table, row - 1, "missing"));
    }
  }
}

/// Points lie on the exact lines but for rounding, and within two cells where corners are rounded to the grid.
TEST(StudyTracking, PointsOfIntersectionsLieOnTheirLines) {
  const std::vector<NamedScene> models{{"60 boxes", penetrating_boxes(60)}};
  const Table table = find_experiment("tracking")->run({StudySize::small, models}).tables[1];
  std::uint64_t points = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    points += count_in(table, row, "points");
    EXPECT_EQ(count_in(table, row, "points of pairs without a line"), 0u);
    EXPECT_LT(number_in(table, row, "greatest distance"), 1e-3);
    EXPECT_LT(number_in(table, row, "greatest distance, whole"), 2);
  }
  EXPECT_GT(points, 10u);
}

TEST(StudyTracking, RememberedDivisionsSpareParts) {
  const Table table = run_small("remembered-divisions").tables[0];
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_LT(count_in(table, row, "parts, remembered"), count_in(table, row, "parts, anew"));
    EXPECT_LT(count_in(table, row, "operations, remembered"), count_in(table, row, "operations, anew"));
    EXPECT_GT(count_in(table, row, "divisions remembered"), 0u);
  }
}

/// However far ahead one task prepares, the other studies the same lines.
TEST(StudyTracking, LinesAheadChangeNoCount) {
  const Table table = run_small("two-tasks").tables[0];
  ASSERT_EQ(table.rows.size() % 3, 0u);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_EQ(count_in(table, row, "lines studied"), count_in(table, row - row % 3, "lines studied"));
    EXPECT_EQ(count_in(table, row, "segments"), count_in(table, row - row % 3, "segments"));
  }
}

}  // namespace
}  // namespace ligne::studies
