// Every experiment at small size: its form, and counts that are known. Times are never looked at.

#include "base/parallel.hpp"
#include "studies/results/result_text.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

Result run(std::string_view name) {
  const Experiment* experiment = find_experiment(name);
  if (!experiment) throw std::runtime_error("there is no experiment " + std::string(name));
  return experiment->run({StudySize::small, {}});
}

/// All rows of a count, in order.
std::vector<std::uint64_t> counts(const Table& table, std::string_view column) {
  std::vector<std::uint64_t> list;
  for (std::size_t i = 0; i < table.rows.size(); ++i) list.push_back(count_in(table, i, column));
  return list;
}

using Counts = std::vector<std::uint64_t>;

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

// Counts that are known, by the section or figure of the source.
TEST(Study, KnownCounts) {
  const struct {
    const char *source, *experiment;
    std::size_t table;
    const char* column;
    Counts counts;
  } rows[] = {
      // One test in three of the children, all thirteen in the fourth.
      {"2.2.3.1, figure 2.11", "edge-tests", 0, "side remembered", {1, 13, 1, 1}},
      {"2.2.3.1, figure 2.11", "edge-tests", 0, "not remembered, at the worst", {13, 13, 13, 13}},
      {"2.2.3.3", "windows", 0, "windows", {49, 67, 21, 1}},
      {"2.2.3.3", "windows", 0, "the triangle moved by (4, 2) mm", {53, 117, 41, 1}},
      // The span methods of the program on n squares, as they were first measured.
      {"2.3.3.4", "squares", 1, "our merge", {9,   19,  29, 39, 49, 25, 58, 91, 124, 157, 25,  54, 89,
                                              124, 159, 19, 39, 59, 79, 99, 24, 54,  84,  114, 144}},
      {"2.3.3.4", "squares", 1, "our stack", {15,  32,  49, 66, 103, 39,  93,  169, 255, 368, 39,  97, 182,
                                              269, 387, 32, 82, 164, 252, 350, 40,  97,  173, 255, 363}},
      {"2.3.3.4", "squares", 1, "our box", {8,   32,  70, 108, 160, 64,  203, 346, 551, 659, 45,  232, 276,
                                            575, 756, 32, 66,  100, 134, 168, 36,  129, 240, 450, 558}},
      {"figures 2.66 and 2.67", "slab-order", 0, "clips", {7, 4}},
      {"2.4.2.4", "clip-sum", 0, "clips", {4, 9, 4, 9, 4, 9}},
      {"2.4.2.4: (n - 1) r + 1", "clip-sum", 0, "regions seen", {9, 19, 13, 28, 21, 46}},
      {"2.5.2.7", "list-cases", 0, "pairs compared", {0, 0}},
      {"2.5.2.7", "list-cases", 0, "slabs", {10, 100}},
      {"2.5.2.7", "list-cases", 2, "pieces", {2, 3, 4, 5, 6, 7}},
      {"lecture 5.1", "depth-increments", 0, "pixels", {136, 136, 136}},
  };
  std::map<std::string_view, Result> results;
  for (const auto& row : rows) {
    if (!results.contains(row.experiment)) results[row.experiment] = run(row.experiment);
    EXPECT_EQ(counts(results[row.experiment].tables.at(row.table), row.column), row.counts)
        << row.source << ": " << row.experiment << ", " << row.column;
  }
  EXPECT_EQ(results["squares"].tables[0].rows.size(), 5u * 7u);
  EXPECT_EQ(counts(run("sort-keys").tables[0], "wrong")[0], 2u) << "figure 2.68, by the nearest point";
}

// 2.2.3.2: the more is understood the fewer windows there are.
TEST(Study, UnderstandingSavesWindows) {
  const Table table = run("understanding").tables[0];
  const Counts windows = counts(table, "windows");
  for (std::size_t i = 0; i + 3 < windows.size(); i += 4) {
    EXPECT_GT(windows[i], windows[i + 1]);
    EXPECT_GE(windows[i + 1], windows[i + 2]);
    EXPECT_GE(windows[i + 2], windows[i + 3]);
  }
}

// 2.3.3.1: sorted segments are the cheapest, and 2-1-3 costs a third more than 1-2-3.
TEST(Study, OrdersOfMerge) {
  const Table table = run("merge-orders").tables[0];
  const Counts operations = counts(table, "merge from the head, operations");
  ASSERT_EQ(operations.size(), 6u);
  EXPECT_NEAR(double(operations[2]) / double(operations[0]), 1.35, 0.05);
  // All orders: 1.64 where the source has 1.3.
  EXPECT_EQ(std::ranges::max(operations), 157u);
  EXPECT_EQ(std::ranges::min(operations), 96u);
  EXPECT_EQ(run("merge-orders").finding, Finding::in_part);
}

// 1.1: what is carried is tested and carried in all, and gives the same strokes.
TEST(Study, Propagation) {
  const Table table = run("propagation").tables[0];
  ASSERT_EQ(table.rows.size() % 4, 0u);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_EQ(count_in(table, i, "tested") + count_in(table, i, "gone on"), count_in(table, i, "edges"));
    const std::size_t test = i - i % 4;
    EXPECT_LE(count_in(table, i, "edge against face"), count_in(table, test, "edge against face"));
    EXPECT_EQ(count_in(table, i, "strokes"), count_in(table, test, "strokes"));
  }
  EXPECT_EQ(count_in(table, 0, "edge against face"), 99u) << "a ring of 9 bars, each edge over or beside some of the others";
}

// Conclusion: trees are built once, and what is deduced of faces and edges is right, or the finding says that it is not.
TEST(Study, SuccessiveViews) {
  const Result result = run("successive-views");
  EXPECT_NE(result.finding, Finding::no_longer);
  const Table& table = result.tables[0];
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string what = std::get<std::string>(table.rows[i][2]);
    const std::uint64_t alone = count_in(table, i, "each by itself"), following = count_in(table, i, "from the one before");
    if (what.find("tree") != std::string::npos) {
      EXPECT_EQ(alone, 4 * following) << what;
    }
    if (what.find("asked") != std::string::npos) {
      EXPECT_LT(following, alone) << what;
    }
  }
}

// 2.2.3.2 and 2.2.3.4: counts keep to their bounds; without penetration a surrounder has one depth for four, and where
// nothing is deceived by the corner that is looked at there are as many windows.
TEST(Study, WindowCosts) {
  const Result result = run("window-costs");
  EXPECT_EQ(result.finding, Finding::holds);
  const Table &sides = result.tables[0], &depths = result.tables[1];
  for (std::size_t i = 0; i < sides.rows.size(); ++i) {
    EXPECT_LE(count_in(sides, i, "at least"), count_in(sides, i, "tests"));
    EXPECT_LE(count_in(sides, i, "tests"), count_in(sides, i, "at most"));
  }
  for (std::size_t i = 0; i < depths.rows.size(); i += 2) {
    EXPECT_LE(count_in(depths, i, "their depths"), 4 * count_in(depths, i, "surrounders"));
    EXPECT_LE(count_in(depths, i + 1, "their depths"), count_in(depths, i + 1, "surrounders"));
    EXPECT_EQ(count_in(depths, i, "at most"), 8 * count_in(depths, i, "intersectors"));
    EXPECT_EQ(count_in(depths, i + 1, "at most"), 2 * count_in(depths, i + 1, "intersectors"));
  }
  // A square turned by 40 degrees before a triangle: planes that are parallel, so that one corner tells as much as four.
  EXPECT_EQ(count_in(depths, 0, "windows"), count_in(depths, 1, "windows"));
  EXPECT_EQ(count_in(depths, 0, "their depths"), 4 * count_in(depths, 1, "their depths"));
}

// 2.2.3.2, second case: two covers that penetrate take 12 depths an intersector. A square behind two plates that cross is
// hidden by their farther depth; a square in the notch between them is behind the nearer one only, which takes four depths
// more, at the two ends of the line in which they cross.
TEST(Study, WindowCostsOfTwoCovers) {
  const Table table = run("window-costs").tables[2];
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_LE(count_in(table, i, "their depths"), count_in(table, i, "4 E"));
    EXPECT_LE(count_in(table, i, "depths with both"), count_in(table, i, "at most"));
    EXPECT_GT(count_in(table, i, "of two covers"), 0u);
  }
  constexpr std::size_t kBehind = 0, kNotch = 3, kFarther = 1, kNearer = 2;  // three rows a scene
  for (const std::size_t row : {kBehind + kFarther, kBehind + kNearer, kNotch + kNearer}) {
    EXPECT_EQ(count_in(table, row, "windows"), 1u);
    EXPECT_EQ(count_in(table, row, "of two covers"), 1u);
    EXPECT_EQ(count_in(table, row, "surrounders"), 2u);
    EXPECT_EQ(count_in(table, row, "their depths"), 8u);
    EXPECT_EQ(count_in(table, row, "4 (E - 1)"), 4u);
    EXPECT_EQ(count_in(table, row, "intersectors"), 1u);
    EXPECT_EQ(count_in(table, row, "depths with both"), row < kNotch ? 12u : 16u);
  }
  EXPECT_EQ(count_in(table, kBehind + kFarther, "at most"), 12u);
  EXPECT_GT(count_in(table, kBehind, "windows"), 1u) << "divided";
  EXPECT_GT(count_in(table, kNotch + kFarther, "windows"), 1u) << "before the farther depth";
}

// Figures 2.24 and 2.25: the coarser the tests the fewer windows; a precision of one point draws the ring of nine bars
// without a fault, a hundredth of it does not.
TEST(Study, PrecisionOfTests) {
  const Table table = run("modules").tables[1];
  constexpr std::size_t kRows = 4;  // E = 0.01, 0.1, 1, 10 of each scene
  for (std::size_t row = 0; row < table.rows.size(); row += kRows) {
    for (std::size_t e = row + 1; e < row + kRows; ++e)
      EXPECT_LE(count_in(table, e, "windows"), count_in(table, e - 1, "windows"));
    EXPECT_LE(number_in(table, row + 2, "wrong mm"), number_in(table, row, "wrong mm"));
  }
  const std::size_t ring = kRows;
  EXPECT_LT(2 * count_in(table, ring + 2, "windows"), count_in(table, ring, "windows"));
  EXPECT_GT(number_in(table, ring, "wrong mm"), 0);
  EXPECT_EQ(number_in(table, ring + 2, "wrong mm"), 0);
}

// 2.3.3.2: squares at 0 degrees are two segments each that begin and end together: a search for each end but the first, no
// depth test, one push and one pop a square.
TEST(Study, StackCost) {
  const Result result = run("stack-cost");
  EXPECT_EQ(result.finding, Finding::holds);
  const Table& table = result.tables[0];
  for (const std::size_t row : {0u, 1u}) {
    const std::uint64_t squares = row == 0 ? 5 : 10;
    EXPECT_EQ(count_in(table, row, "segments"), 2 * squares);
    EXPECT_EQ(count_in(table, row, "searches"), 4 * squares - 1);
    EXPECT_EQ(count_in(table, row, "shown"), 2 * squares - 1);
    EXPECT_EQ(count_in(table, row, "depth tests"), 0u);
    EXPECT_EQ(count_in(table, row, "pushes"), squares);
    EXPECT_EQ(count_in(table, row, "pops"), squares);
  }
}

// Figure 2.88: a slab before another, zones of slabs of zones in it; five faces, each a set of its own, and no list.
TEST(Study, Decomposition) {
  const Table table = run("decomposition").tables[0];
  std::vector<std::string> sets;
  std::uint64_t leaves = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    sets.push_back(std::get<std::string>(table.rows[i][0]));
    leaves += std::get<std::string>(table.rows[i][1]) == "one face";
    EXPECT_NE(std::get<std::string>(table.rows[i][1]), "a list, sorted");
  }
  EXPECT_EQ(sets, (std::vector<std::string>{"whole", "1", "2", "2.1", "2.1.1", "2.1.1.1", "2.1.1.2", "2.1.2", "2.2"}));
  EXPECT_EQ(leaves, 5u);
  EXPECT_EQ(run("decomposition").finding, Finding::holds);
}

// 2.6: zones in parallel. Figure 2.88 ends in single faces; of a grid of crowds each is a zone, with a list if its boxes
// meet.
TEST(Study, Zones) {
  const Result result = run("zones");
  const Table& table = result.tables[0];
  EXPECT_EQ(result.finding, Finding::holds);
  EXPECT_EQ(counts(table, "lists")[0], 0u);
  EXPECT_EQ(counts(table, "pairs compared")[0], 0u);
  for (const std::size_t row : {1u, 2u}) {
    SCOPED_TRACE(row);
    EXPECT_GE(count_in(table, row, "zones"), 25u);
    EXPECT_GE(count_in(table, row, "lists"), 20u);
    EXPECT_GT(count_in(table, row, "cuts"), 20u);
    EXPECT_NEAR(number_in(table, row, "bound of the gain"),
                double(count_in(table, row, "pairs compared")) / double(count_in(table, row, "pairs of the list with most")),
                1e-12);
  }
  EXPECT_EQ(count_in(table, 2, "elements of the longest"), 144u);
  EXPECT_GT(number_in(table, 1, "bound of the gain"), 10);
  EXPECT_LT(number_in(table, 2, "bound of the gain"), 1.5);
  for (const auto& row : table.rows) EXPECT_EQ(std::get<std::string>(row[column_of(table, "one order")]), "yes");
}

// Figure 2.56.
TEST(Study, StackDoesNotCareWhereTheSceneLies) {
  const Table table = run("translation").tables[0];
  const Counts stack = counts(table, "stack"), box = counts(table, "box, divided in the middle");
  EXPECT_EQ(std::set(stack.begin(), stack.end()).size(), 1u);
  EXPECT_GT(std::set(box.begin(), box.end()).size(), 2u);
}

// 2.3.5.3 and 2.3.6.3.
TEST(Study, Coherence) {
  const Table table = run("coherence").tables[0];
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_GT(count_in(table, i, "every line"), count_in(table, i, "where edges enter, end, cross"));
    EXPECT_GE(count_in(table, i, "where edges enter, end, cross"), count_in(table, i, "and it can be seen"));
  }
  const Table groups = run("line-groups").tables[0];
  EXPECT_EQ(counts(groups, "groups")[0], 512u);
  EXPECT_EQ(counts(groups, "groups")[3], 1u);
}

// 2.6: every method draws the line along which two plates penetrate, outside of what hides it.
TEST(Study, FourMethods) {
  const Table table = run("four-methods").tables[0];
  int methods = 0;
  for (const auto& row : table.rows) {
    if (std::get<std::string>(row[1]) != "lines of intersection") continue;
    EXPECT_GT(std::get<std::uint64_t>(row[4]), 0u);
    ++methods;
  }
  EXPECT_EQ(methods, 4);
}

// Lecture 5.1 and Huet 3.1.
TEST(Study, OtherSources) {
  const Table depth = run("depth-increments").tables[0];
  EXPECT_EQ(number_in(depth, 0, "products"), 2);
  EXPECT_EQ(number_in(depth, 1, "products"), 0);
  const Table trees = run("tree-complexity").tables[0];
  EXPECT_EQ(count_in(trees, 0, "complexity"), 0u);
  EXPECT_EQ(count_in(trees, 1, "complexity"), 0u);
  EXPECT_EQ(count_in(trees, 1, "convex sets"), 10u);
}

}  // namespace
}  // namespace ligne::studies
