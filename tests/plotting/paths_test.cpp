/// Ordering strokes, that a drawing never changes by it, and the search for near ends.

#include <chrono>

#include "base/parallel.hpp"
#include "drawing/measures.hpp"
#include "geometry/search/nearest_points.hpp"
#include "main/tier.hpp"
#include "plotting/paths/optimize.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

using namespace test;

/// Largest distance of a point of `from`, sampled finely, from `to`.
double farthest(const Polylines& from, const Polylines& to) {
  double worst = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto line = from[i];
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Point2 next = line[std::min(k + 1, line.size() - 1)];
      for (int s = 0; s < 7; ++s) worst = std::max(worst, distance_to_lines(line[k] + (next - line[k]) * (s / 7.0), to));
    }
  }
  return worst;
}

double sum(const JoinTolerances& t) { return t.ends_mm + t.overlap_mm + t.simplify_mm; }

TEST(OrderStrokes, AClosedLineStartsWhereItIsNear) {
  const Polylines ordered = order_strokes(lines_of_text("0,0 90,0 90,90 0,90 0,0"), {.home = {100, 0}});
  EXPECT_EQ(text_of_lines(ordered), "90,0 90,90 0,90 0,0 90,0");
}

/// All orders and directions of few strokes.
double best_way(const Polylines& lines, Point2 home, bool returns) {
  std::vector<std::size_t> order(lines.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  double best = 1e300;
  do {
    for (unsigned turned = 0; turned < 1u << lines.size(); ++turned) {
      Point2 pen = home;
      double way = 0;
      for (const std::size_t i : order) {
        const bool back = turned >> i & 1;
        way += glm::distance(pen, back ? lines[i].back() : lines[i].front());
        pen = back ? lines[i].front() : lines[i].back();
      }
      best = std::min(best, way + (returns ? glm::distance(pen, home) : 0));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(OrderStrokes, FewStrokesAreInTheBestOrderOrNear) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 100);
  double sum_found = 0, sum_best = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<std::vector<Point2>> lists;
    for (int i = 0; i < 6; ++i) lists.push_back({{place(random), place(random)}, {place(random), place(random)}});
    const Polylines lines = polylines_of(lists);
    OrderOptions options{.returns = round % 2 == 1};
    const double best = best_way(lines, options.home, options.returns);
    const double found = measure(order_strokes(lines, options), options.home, options.returns).up_mm;
    EXPECT_GE(found, best - 1e-9);
    EXPECT_LE(found, 1.35 * best);
    sum_found += found;
    sum_best += best;
  }
  EXPECT_LE(sum_found, 1.04 * sum_best);
}

Polylines random_drawing(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> node(0, 12), count(2, 7), kind(0, 5);
  std::uniform_real_distribution<double> jitter(-0.012, 0.012), place(0, 60);
  std::vector<std::vector<Point2>> lists;
  for (int i = 0; i < 40; ++i) {
    std::vector<Point2> line;
    const int points = count(random), what = kind(random);
    for (int k = 0; k < points; ++k) {
      Point2 p{node(random) * 5.0, node(random) * 5.0};
      if (what == 1) p += Point2{jitter(random), jitter(random)};
      if (what == 2) p = {place(random), place(random)};
      line.push_back(p);
    }
    if (what == 3) line.push_back(line.front());
    if (what == 4) {  // a fine curve
      line.clear();
      const Point2 c{place(random), place(random)};
      for (int k = 0; k < 200; ++k) line.push_back({c.x + k * 0.05, c.y + 4 * std::sin(k * 0.05)});
    }
    lists.push_back(line);
    if (what == 5) lists.push_back({line.rbegin(), line.rend()});
  }
  return polylines_of(lists);
}

/// Squares in squares, three deep, and an open line in one of them: everything comes before what surrounds it.
TEST(OrderStrokes, CuttersCutHolesFirst) {
  Polylines lines;
  for (int i = 0; i < 20; ++i) {
    const Point2 at(30.0 * i, 7.0 * (i % 3));
    Polylines more = lines_of_text("0,0 20,0 20,20 0,20 0,0; 2,2 12,2 12,12 2,12 2,2; 4,4 7,4 7,7 4,7 4,4; 15,15 18,15");
    for (Point2& p : more.points) p += at;
    for (std::size_t k = 0; k < more.size(); ++k) lines.add(more[k]);
  }
  OrderOptions options{.inside_first = true};
  std::vector<std::uint32_t> order;
  const Polylines ordered = order_strokes(lines, options, &order);
  EXPECT_EQ(ordered.size(), lines.size());
  std::vector<std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t s = 0; s < order.size(); s += 4) {
    EXPECT_LT(place[s + 2], place[s + 1]);
    EXPECT_LT(place[s + 1], place[s]);
    EXPECT_LT(place[s + 3], place[s]);
  }
  options.inside_first = false;
  order_strokes(lines, options, &order);
  bool outer_first = false;
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t s = 0; s < order.size(); s += 4) outer_first = outer_first || place[s] < place[s + 1];
  EXPECT_TRUE(outer_first) << "the order would have come about by itself";
}

TEST(OptimizePaths, ADrawingIsTheSameSetOfPoints) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    if (!is_chosen("paths", seed, 5)) continue;
    const Polylines lines = random_drawing(seed);
    PathOptions options;
    const Polylines better = optimize_paths(lines, options);
    EXPECT_LE(farthest(lines, better), sum(options.tolerances)) << seed;
    EXPECT_LE(farthest(better, lines), sum(options.tolerances)) << seed;
    EXPECT_LE(total_length(better), total_length(lines) + 40 * options.tolerances.ends_mm) << seed;
    EXPECT_LE(measure(better, {0, 0}, false).up_mm, measure(lines, {0, 0}, false).up_mm) << seed;
    EXPECT_LE(better.size(), lines.size() * 3) << seed;
  }
}

TEST(OptimizePaths, AnOrderThatWasGoodIsNotMadeWorse) {
  // Rows drawn to and fro, then a last one far away: nearest neighbours from a home in the middle leave some behind.
  for (unsigned seed = 0; seed < 40; ++seed) {
    Polylines lines = random_drawing(seed);
    for (const bool returns : {false, true}) {
      OrderOptions options{.home = {50, 50}, .returns = returns};
      std::vector<std::uint32_t> order;
      for (int round = 0; round < 3; ++round) {
        const Polylines better = order_strokes(lines, options, &order);
        EXPECT_LE(measure(better, options.home, returns).up_mm, measure(lines, options.home, returns).up_mm + 1e-9) << seed;
        ASSERT_EQ(order.size(), lines.size());
        for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(better[i].size(), lines[order[i]].size());
        lines = better;
      }
    }
  }
}

TEST(OptimizePaths, OrderingAloneKeepsEveryPoint) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Polylines lines = join_strokes(random_drawing(seed), {});
    const Polylines ordered = order_strokes(lines, {});
    EXPECT_EQ(ordered.size(), lines.size());
    EXPECT_NEAR(total_length(ordered), total_length(lines), 1e-6);
    EXPECT_LE(farthest(ordered, lines), 1e-9);
    EXPECT_LE(farthest(lines, ordered), 1e-9);
  }
}

TEST(OptimizePaths, OffIsOff) {
  const Polylines lines = random_drawing(1);
  PathOptions options;
  options.optimize = Optimize::off;
  EXPECT_EQ(optimize_paths(lines, options).points, lines.points);
}

Polylines many_strokes(std::size_t n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 1000), step(-4, 4);
  Polylines lines;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Point2> line{{place(random), place(random)}};
    while (line.size() < 5) line.push_back(line.back() + Point2{step(random), step(random)});
    lines.add(line);
  }
  return lines;
}

TEST(OptimizePaths, TheSameWithAnyNumberOfThreads) {
  const Polylines lines = many_strokes(3000);
  Polylines one;
  run_with_threads(1, [&] { one = optimize_paths(lines, {}); });
  const Polylines many = optimize_paths(lines, {});
  EXPECT_EQ(one.points, many.points);
  EXPECT_EQ(one.begin, many.begin);
}

TEST(OptimizePaths, AHundredThousandStrokesAreWellOrdered) {
  const Polylines lines = many_strokes(runs_all() ? 100'000 : 40'000);
  const Polylines better = optimize_paths(lines, {});
  const double before = measure(lines, {0, 0}, false).up_mm, after = measure(better, {0, 0}, false).up_mm;
  EXPECT_LT(after, before / 100);
}

TEST(OptimizePaths, StarsAndHeapsTakeNoLonger) {
  // All strokes end in one point, which is where searches for near ends degenerate.
  for (const char* lines : {"0..39999:100+mod(k,2)*90*cos(k/200),100+mod(k,2)*90*sin(k/200) each 2",
                            "0..39999:if(mod(k,2)==0,mod(k/2,3),mod((k-1)/2,5))*1e-4,mod(k,2)*1e-4 each 2"}) {
    const auto start = std::chrono::steady_clock::now();
    optimize_paths(lines_of_text(lines), {});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  }
}

/// In the order of distance, of those that remain.
TEST(NearestPoints, FindsTheNearestOfTheRemainingPoints) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-20, 20);
  std::vector<Point2> points(500);  // many lie in one place
  for (Point2& p : points) p = {place(random), place(random)};
  NearestPoints tree(points);
  std::vector<char> there(points.size(), 1);
  std::vector<NearestPoints::Neighbour> nearest;
  for (std::size_t removed = 0; removed < points.size(); ++removed) {
    const Point2 q{place(random) + 0.5, place(random) - 0.25};
    std::vector<double> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (there[i]) expected.push_back(glm::dot(q - points[i], q - points[i]));
    std::sort(expected.begin(), expected.end());
    tree.nearest(q, 10, nearest);
    ASSERT_EQ(nearest.size(), std::min<std::size_t>(10, expected.size()));
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      ASSERT_TRUE(there[nearest[i].point]);
      ASSERT_EQ(nearest[i].squared, expected[i]);
    }
    tree.remove(nearest[0].point);
    there[nearest[0].point] = 0;
  }
  tree.nearest({0, 0}, 1, nearest);
  EXPECT_TRUE(nearest.empty());
}

}  // namespace
}  // namespace ligne
