/// Searches of the cleaning of lines: cells of lines, the tree of points, overlapping strokes.

#include "geometry/point.hpp"
#include "geometry/search/line_cells.hpp"
#include "geometry/search/point_tree.hpp"
#include "geometry/search/segment_end_tree.hpp"
#include "geometry/segment_overlap.hpp"
#include "linework/overlaps/overlap_search.hpp"
#include "main/tier.hpp"
#include "stroke_builder.hpp"

namespace ligne {
namespace {

TEST(WalkedCell, IsNoHairWhereStrokesAreLong) {
  const std::vector<Stroke> strokes(100, stroke({0, 0}, {3'000'000, 4'000'000}));
  EXPECT_EQ(walked_cell(strokes, 5000), 5000) << "few cells";
  EXPECT_EQ(walked_cell({}, 1e-6), 1e-6);
  for (const double wanted : {1.0, 1e-6}) {
    const LineCells grid(walked_cell(strokes, wanted));
    std::size_t cells = 0;
    for (const Stroke& s : strokes) grid.walk(s.from, s.to, wanted, [&](std::uint64_t) { return ++cells, false; });
    EXPECT_LT(cells, 1'000'000u) << wanted;
    EXPECT_GT(cells, 10'000u) << wanted;
  }
}

// The tree of points against a look at all points.

/// Points with whole coordinates, of which many lie in one place.
std::vector<TreePoint<2>> crowded_points(std::size_t count, int extent) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-extent, extent);
  std::vector<TreePoint<2>> points(count);
  for (TreePoint<2>& p : points) p = {place(random), place(random)};
  return points;
}

TEST(PointTree, VisitsTheLeavesOfTheBoxesThatAreEntered) {
  const std::vector<TreePoint<2>> points = crowded_points(3000, 50);
  const PointTree<2> tree(points);
  for (std::size_t i = 0; i < 50; ++i) {
    const Point2 p(points[i][0], points[i][1]);
    const double reach = double(i);
    std::vector<std::uint32_t> found, expected;
    tree.search_from(
        p,
        [&](std::uint32_t node, double squared) {
          EXPECT_EQ(squared, tree.box(node).squared_distance(p));
          return squared <= reach * reach;
        },
        [&](std::uint32_t place) { found.push_back(tree.order()[place]); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t k = 0; k < points.size(); ++k)
      if (PointBox<2>{points[k], points[k]}.squared_distance(p) <= reach * reach) expected.push_back(k);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    EXPECT_TRUE(i >= 5 || found.size() < points.size() / 4);
  }
}

TEST(PointTree, EveryPointIsInTheNodesAroundIt) {
  const std::vector<TreePoint<2>> points = crowded_points(500, 8);
  const PointTree<2> tree(points);
  std::vector<std::uint32_t> met(tree.node_count(), 0);
  for (std::uint32_t place = 0; place < points.size(); ++place) {
    tree.for_each_around(place, [&](std::uint32_t node) {
      const TreePoint<2> p = points[tree.order()[place]];
      EXPECT_EQ(tree.box(node).squared_distance(Point2(p[0], p[1])), 0);
      ++met[node];
    });
  }
  for (std::uint32_t node = 0; node < tree.node_count(); ++node) EXPECT_EQ(met[node], tree.size_of(node));
}

/// Else each search from a place where thousands of lines meet looks into all parts of the tree.
TEST(PointTree, KeepsThePointsOfOnePlaceTogether) {
  std::vector<TreePoint<2>> points = crowded_points(4000, 1000);
  points.resize(8000, {0, 0});
  std::size_t parts = 0;
  const auto enter = [&](const PointBox<2>& box) {
    const bool is_place = box.low == points.back() && box.high == points.back();
    parts += is_place;
    return !is_place && box.squared_distance(Point2(0, 0)) == 0;
  };
  PointTree<2>(points).search(enter, [](std::uint32_t) {});
  EXPECT_LE(parts, 2u);
}

TEST(PointTree, OfNoPointsHasNothingToVisit) {
  const PointTree<2> none(std::vector<TreePoint<2>>{});
  const auto fail = [](std::uint32_t) { FAIL(); };
  none.search_from(
      Point2(0, 0), [](std::uint32_t, double) { return true; }, fail);
  none.search([](const PointBox<2>&) { return true; }, fail);
}

// The search for overlaps against all pairs.

constexpr double kTolerance = 3;

std::vector<StrokePair> by_all_pairs(const std::vector<Stroke>& strokes) {
  std::vector<StrokePair> pairs;
  for (std::uint32_t i = 0; i < strokes.size(); ++i)
    for (std::uint32_t k = 0; k < i; ++k) {
      const Stroke &a = strokes[i], &b = strokes[k];
      if (!a.needs_overlap_check && !b.needs_overlap_check) continue;
      if (overlap(a.from, a.to, b.from, b.to, kTolerance)) pairs.push_back({i, k});
    }
  return pairs;
}

ComparedStrokes compared(const std::vector<Stroke>& strokes) {
  ComparedStrokes all;
  for (const Stroke& s : strokes) {
    if (page_length(s) > kTolerance) all.add({&s, 1});
  }
  return all;
}

/// Every fifth stroke, cut in the middle.
std::vector<CutStroke> some_cut(const std::vector<Stroke>& strokes) {
  std::vector<CutStroke> cut;
  for (std::uint32_t i = 0; i < strokes.size(); i += 5) {
    Stroke half = strokes[i];
    half.to = {std::midpoint(half.from.x, half.to.x), std::midpoint(half.from.y, half.to.y)};
    if (page_length(half) > kTolerance) cut.push_back({i, {half}});
  }
  return cut;
}

/// Searches again and again, after strokes were cut and others added.
void expect_found(const std::vector<Stroke>& strokes, std::uint32_t seed) {
  const std::vector<Stroke> wanted = compared(strokes).strokes;
  OverlapSearch search(kTolerance);
  ComparedStrokes all;
  for (const std::size_t share : {40, 20, 3, 2, 1}) {
    all.add(std::span(wanted).first(wanted.size() / share).subspan(all.strokes.size()));
    const std::vector<StrokePair> found = search.find_new(all);
    std::vector<StrokePair> expected = by_all_pairs(all.strokes);
    std::erase_if(expected, [&](const StrokePair& p) { return !all.is_new(p.later) && !all.is_new(p.earlier); });
    EXPECT_TRUE(found == expected) << found.size() << ", seed " << seed << ", one in " << share;
    all.replace(some_cut(all.strokes));
  }
}

/// Strokes of about `length`, most of which begin on a line of another, near it, or near an end of it, at angles down to
/// none.
std::vector<Stroke> clustered(std::uint32_t seed, int count, int page, int shortest, int longest) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto within = [&](int n) { return below(2 * n + 1) - n; };
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    LatticePoint from{within(page), within(page)};
    double angle = below(6283) / 1000.0;
    const double ratio = below(1001) / 1000.0;
    const double l = shortest * std::pow(double(longest) / shortest, ratio);
    if (i > 0 && below(4) > 0) {
      const Stroke& other = strokes[static_cast<std::size_t>(below(i))];
      const double dx = double(other.to.x) - other.from.x, dy = double(other.to.y) - other.from.y;
      const double at = below(3) == 0 ? below(2) : below(1001) / 1000.0;
      const int off = below(2) == 0 ? 0 : below(2) == 0 ? 4 : 300;
      from = {other.from.x + static_cast<int>(std::lround(at * dx)) + within(off),
              other.from.y + static_cast<int>(std::lround(at * dy)) + within(off)};
      angle = std::atan2(dy, dx) + 3.14159265358979 * below(2) + within(100) / 100.0 * 5 / l * (1 << below(8));
    }
    const LatticePoint to = moved(from, {l * std::cos(angle), l * std::sin(angle)});
    Stroke s = stroke(from, to, LineClass::mesh, std::uint32_t(i));
    s.needs_overlap_check = below(3) > 0;
    strokes.push_back(s);
  }
  return strokes;
}

const std::uint32_t kSeeds = test::runs_all() ? 10 : 2;

/// All in the middle of a large page but for four: their mean distance on the page says nothing of the crowd.
std::vector<Stroke> crowded_on_a_large_page(std::uint32_t seed) {
  std::vector<Stroke> strokes = clustered(seed, 3000, 10'000, 3000, 12'000);
  constexpr int kFar = kLatticeLimit - 1000;
  for (const LatticePoint corner : {LatticePoint{kFar, kFar}, {kFar, -kFar}, {-kFar, kFar}, {-kFar, -kFar}}) {
    strokes.push_back(stroke(corner, {corner.x + 500, corner.y}, LineClass::mesh, 0));
    strokes.back().needs_overlap_check = true;
  }
  return strokes;
}

std::vector<Stroke> far_and_few_may_coincide(std::uint32_t seed) {
  std::vector<Stroke> strokes = clustered(seed, 700, 20'000'000, 1000, 10'000'000);
  for (std::size_t i = 0; i < strokes.size(); ++i) strokes[i].needs_overlap_check = i % 50 == 0;
  return strokes;
}

TEST(OverlappingStrokes, AreThoseOfAllPairs) {
  const struct {
    const char* name;
    std::uint32_t seeds;
    std::function<std::vector<Stroke>(std::uint32_t)> make;
  } rows[] = {{"all lengths", kSeeds, [](auto seed) { return clustered(seed, seed % 2 ? 3000 : 700, 5'000, 50, 60'000); }},
              {"long strokes", kSeeds, [](auto seed) { return clustered(seed, 2000, 1'000'000, 20'000, 1'000'000); }},
              {"about as long as the short ones", kSeeds, [](auto seed) { return clustered(seed, 2000, 1000, 150, 250); }},
              {"a crowd", 2, [](auto seed) { return clustered(seed, 3000, 300, 20, 2000); }},
              {"a crowd on a large page", kSeeds / 2, crowded_on_a_large_page},
              {"far strokes of which few may coincide", kSeeds, far_and_few_may_coincide}};
  for (const auto& [name, seeds, make] : rows) {
    SCOPED_TRACE(name);
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) expect_found(make(seed), seed);
  }
}

/// The ends along one stroke do not grow in number with the strokes that cross it, lie beside it, or end on it.
TEST(OverlappingStrokes, OfThousandsThroughOnePointAndSideBySideFewAreFound) {
  constexpr double kStraight = 1;  // the direction of lines along x
  constexpr int kCount = 20'000, kLength = 1'000'000;
  std::vector<PlacedEnd> crossing, ending, beside;
  const auto add = [](std::vector<PlacedEnd>& ends, LatticePoint a, LatticePoint b, int stroke) {
    ends.push_back({a, b, static_cast<std::uint32_t>(stroke)});
    ends.push_back({b, a, static_cast<std::uint32_t>(stroke)});
  };
  for (int i = 0; i < kCount; ++i) {
    const LatticePoint end{kLength, 3 * i - 3 * kCount / 2};
    add(crossing, {-end.x, -end.y}, end, i);
    add(ending, {0, 0}, end, i);
    add(beside, {0, 20 * i}, {kLength, 20 * i + i % 7}, i);
  }
  const SegmentEndTree across(crossing, kStraight, kTolerance), at_point(ending, kStraight, kTolerance),
      parallel(beside, kStraight, kTolerance);
  for (int i = 0; i < kCount; i += 100) {
    std::size_t found[3] = {0, 0, 0};
    const LatticePoint end = crossing[static_cast<std::size_t>(2 * i + 1)].p;
    across.for_each_along({{-end.x, -end.y}, end}, [&](const PlacedEnd&) { ++found[0]; });
    at_point.for_each_along({{-end.x, -end.y}, end}, [&](const PlacedEnd&) { ++found[1]; });
    parallel.for_each_along({{0, 20 * i}, {kLength, 20 * i + i % 7}}, [&](const PlacedEnd&) { ++found[2]; });
    for (const std::size_t n : found) EXPECT_TRUE(n >= 2 && n < 128) << i << ": " << n;
  }
}

/// A direction on either side of the axes, where their numbers begin and end.
TEST(OverlappingStrokes, OfNearlyOneDirectionAreFound) {
  for (int k = -40; k <= 40; ++k) {
    const int turn = 700 * k;
    std::vector<Stroke> strokes;
    for (const LatticePoint d : {LatticePoint{100'000, turn}, LatticePoint{turn, 100'000},
                                 LatticePoint{100'000, 100'000 + turn}, LatticePoint{100'000 + turn, -100'000}}) {
      strokes.push_back(stroke({-d.x, -d.y}, d));
      strokes.push_back(stroke({d.x / 2, d.y / 2}, {d.x / 3, d.y / 3 + 1}));
    }
    EXPECT_TRUE(OverlapSearch(kTolerance).find_new(compared(strokes)) == by_all_pairs(strokes)) << turn;
    EXPECT_GE(by_all_pairs(strokes).size(), 4u) << turn;
  }
}

}  // namespace
}  // namespace ligne
