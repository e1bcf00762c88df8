/// Experiments: tables of the studies, and clips of polygons.

#include "studies/experiments.hpp"
#include "base/parallel.hpp"
#include "studies/plates/plates.hpp"
#include "studies/results/result_text.hpp"
#include "studies/scenes/generators.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

// Points of intersections in the experiment on tracking, and the plates.

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

// Every experiment at small size: its form, and what is said in words. Counts: scripts/experiments.txt.

Result run(std::string_view name) {
  const Experiment* experiment = find_experiment(name);
  if (!experiment) throw std::runtime_error("there is no experiment " + std::string(name));
  return experiment->run({StudySize::small, {}});
}

TEST(Study, EveryRowHasTheFigureOfTheSource) {
  std::set<std::string_view> names;
  for (const Experiment& experiment : experiments()) {
    SCOPED_TRACE(experiment.name);
    EXPECT_TRUE(names.insert(experiment.name).second);
    const Result result = experiment.run({StudySize::small, {}});
    EXPECT_FALSE(result.tables.empty());
    EXPECT_FALSE(result.sentence.empty());
    for (const Table& table : result.tables) {
      SCOPED_TRACE(table.title);
      EXPECT_FALSE(table.rows.empty());
      std::size_t sources = 0;
      for (std::size_t c = 0; c < table.columns.size(); ++c) sources += table.columns[c].kind == ColumnKind::source;
      EXPECT_EQ(sources, 1u);
      for (const auto& row : table.rows) {
        ASSERT_EQ(row.size(), table.columns.size());
        for (std::size_t c = 0; c < row.size(); ++c) {
          const ColumnKind kind = table.columns[c].kind;
          if (kind == ColumnKind::source) {
            ASSERT_TRUE(std::holds_alternative<std::string>(row[c]));
            EXPECT_FALSE(std::get<std::string>(row[c]).empty());
          }
          if (std::holds_alternative<std::uint64_t>(row[c])) {
            EXPECT_EQ(kind, ColumnKind::count);
          }
          if (std::holds_alternative<double>(row[c])) {
            EXPECT_TRUE(kind == ColumnKind::measure || kind == ColumnKind::time) << table.columns[c].name;
          }
        }
      }
    }
  }
}

/// Everything but times is the same every time, with one thread and with several.
TEST(Study, CountsAreTheSameForAnyNumberOfThreads) {
  for (const Experiment& experiment : experiments()) {
    SCOPED_TRACE(experiment.name);
    Result one, many;
    run_with_threads(1, [&] { one = run(experiment.name); });
    run_with_threads(4, [&] { many = run(experiment.name); });
    ASSERT_EQ(one.tables.size(), many.tables.size());
    for (std::size_t t = 0; t < one.tables.size(); ++t) {
      const Table &a = one.tables[t], &b = many.tables[t];
      ASSERT_EQ(a.rows.size(), b.rows.size());
      for (std::size_t r = 0; r < a.rows.size(); ++r) {
        for (std::size_t c = 0; c < a.columns.size(); ++c)
          if (a.columns[c].kind != ColumnKind::time) {
            EXPECT_EQ(a.rows[r][c], b.rows[r][c]) << a.title << ", " << a.columns[c].name;
          }
      }
    }
  }
}

TEST(Study, TextJsonAndCsv) {
  const Outcome outcome{find_experiment("windows"), run("windows")};
  const std::string text = text_of(outcome);
  test::expect_parts(text, {"| screen (figure 2.20) | about 60 | 49 | 53 |"});
  const std::string csv = csv_of(std::span(&outcome, 1));
  test::expect_parts(csv, {",screen (figure 2.20),windows,count,49\n"});
  const std::string json = json_of(std::span(&outcome, 1), StudySize::small);
  test::expect_parts(json, {"\"format\": \"ligne-study\"", "\"kind\": \"source\""});
}

TEST(Study, ChartsAreOneFile) {
  const Result result = run("squares");
  EXPECT_EQ(result.charts.size(), 5u);
  const std::string svg = charts_svg(result.charts);
  test::expect_parts(svg, {"<svg", "inkscape:label=\"curve-1\""});
  test::expect_no_parts(svg, {"nan", "inf"});
}

}  // namespace
}  // namespace ligne::studies
