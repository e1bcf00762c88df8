// The experiments on the study of polygons: counts that are known, and relations between them.

#include "studies/experiments.hpp"
#include "studies/plates/plates.hpp"
#include "studies/scenes/generators.hpp"
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

// The experiments on scans by lines as their source describes them: relations between their counts.

/// Twice the lines miss less of the exact strokes, and an end on the next line adds what one on the last does not.
TEST(StudyTracking, FinerLinesMissLess) {
  const Table table = result_of("tracking").tables[0];
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
  const Table table = result_of("remembered-divisions").tables[0];
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_LT(count_in(table, row, "parts, remembered"), count_in(table, row, "parts, anew"));
    EXPECT_LT(count_in(table, row, "operations, remembered"), count_in(table, row, "operations, anew"));
    EXPECT_GT(count_in(table, row, "divisions remembered"), 0u);
  }
}

/// However far ahead one task prepares, the other studies the same lines.
TEST(StudyTracking, LinesAheadChangeNoCount) {
  const Table table = result_of("two-tasks").tables[0];
  ASSERT_EQ(table.rows.size() % 3, 0u);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_EQ(count_in(table, row, "lines studied"), count_in(table, row - row % 3, "lines studied"));
    EXPECT_EQ(count_in(table, row, "segments"), count_in(table, row - row % 3, "segments"));
  }
}

// The plates: their figures, what is on them, and one file.

const std::vector<Plate>& plates() {
  static const std::vector<Plate> made = make_plates();
  return made;
}

const Plate& plate(std::string_view figure) {
  for (const Plate& p : plates())
    if (p.figure == figure) return p;
  throw std::runtime_error("there is no plate " + std::string(figure));
}

bool has_text(const Plate& plate, std::string_view words) {
  return std::ranges::any_of(plate.drawing.texts, [&](const TextItem& item) { return item.text == words; });
}

std::size_t lines_of(const Plate& plate, std::string_view layer) {
  std::size_t sum = 0;
  for (const Layer& l : plate.drawing.layers) sum += l.name == layer ? l.lines.size() : 0;
  return sum;
}

TEST(Plates, AreThoseOfTheSource) {
  std::vector<std::string> figures;
  for (const Plate& p : plates()) figures.push_back(p.figure);
  EXPECT_EQ(figures, (std::vector<std::string>{"2.2", "2.30", "2.57", "2.62", "2.71", "2.72 and 2.73", "2.88"}));
}

/// 12 + 6 vertices and 8 + 5 faces; windows are those that are drawn, each a square.
TEST(Plates, HaveNamesAndCounts) {
  const Plate& views = plate("2.2");
  for (const char* words : {"FRONT VIEW", "SIDE VIEW", "TOP VIEW", "NUMBER OF VERTICES", "18", "NUMBER OF FACES", "13"})
    EXPECT_TRUE(has_text(views, words)) << words;
  EXPECT_GT(lines_of(views, "debug"), 10u);
  EXPECT_GT(lines_of(views, "hidden"), 0u);
  EXPECT_GT(lines_of(plate("2.30"), "hatch"), 40u);
  const Plate& tree = plate("2.88");
  for (int face = 1; face <= 5; ++face) EXPECT_TRUE(has_text(tree, "face " + std::to_string(face)));
  EXPECT_FALSE(plate("2.62").drawing.fills.empty());
  EXPECT_FALSE(plate("2.71").drawing.fills.empty());
}

/// Tracked strokes end on scan lines and columns 3 mm apart, but for the place of their cell.
TEST(Plates, TrackedStrokesEndOnLines) {
  const Plate& tracked = plate("2.57");
  const Layer* grid = nullptr;
  for (const Layer& layer : tracked.drawing.layers)
    if (layer.name == "debug") grid = &layer;
  ASSERT_TRUE(grid);
  const double first = grid->lines[0][0].y, last = grid->lines[grid->lines.size() - 1][0].y;
  std::size_t ends = 0;
  for (const Layer& layer : tracked.drawing.layers) {
    if (layer.name != "outline") continue;
    for (const Point2 p : layer.lines.points) {
      if (p.y > last) continue;  // of the drawing with exact ends, below
      ++ends;
      EXPECT_NEAR(std::remainder(p.y - first, 3), 0, 1e-9);
    }
  }
  EXPECT_GT(ends, 10u);
}

TEST(Plates, AreOneFile) {
  const std::string pdf = plates_pdf(plates());
  EXPECT_TRUE(pdf.starts_with("%PDF"));
  EXPECT_NE(pdf.find("/Count " + std::to_string(plates().size())), pdf.npos);
  EXPECT_EQ(plates_pdf(make_plates()), pdf);
}

}  // namespace
}  // namespace ligne::studies
