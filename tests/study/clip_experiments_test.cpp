// Points of intersections in the experiment on tracking, and the plates.

#include "studies/experiments.hpp"
#include "studies/plates/plates.hpp"
#include "studies/scenes/generators.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

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
