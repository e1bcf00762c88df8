/// The tree of points against a look at all points.

#include "geometry/point_tree.hpp"
#include "base/no_index.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

/// Points with whole coordinates, of which many lie in one place.
std::vector<Point2> crowded_points(std::size_t count, int extent) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-extent, extent);
  std::vector<Point2> points(count);
  for (Point2& p : points) p = {double(place(random)), double(place(random))};
  return points;
}

TEST(PointTree, FindsTheNearestOfTheRemainingPoints) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-20, 20);
  const std::vector<Point2> points = crowded_points(500, 20);
  PointTree tree(points);
  std::vector<char> there(points.size(), 1);
  for (std::size_t removed = 0; removed < points.size(); ++removed) {
    const Point2 q{place(random) + 0.3, place(random) - 0.2};
    const std::uint32_t found = tree.nearest(q);
    double least = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (there[i]) least = std::min(least, glm::distance(q, points[i]));
    }
    ASSERT_NE(found, kNone);
    ASSERT_TRUE(there[found]);
    ASSERT_DOUBLE_EQ(glm::distance(q, points[found]), least);
    tree.remove(found);
    there[found] = 0;
  }
  EXPECT_EQ(tree.nearest({0, 0}), kNone);
}

TEST(PointTree, FindsTheNearestInTheOrderOfDistanceAndIndex) {
  const std::vector<Point2> points = crowded_points(800, 12);
  const PointTree tree(points);
  std::vector<PointTree::Neighbour> found;
  for (int x = -12; x <= 12; ++x) {
    const Point2 p{double(x), 0.5 * x};
    std::vector<std::pair<double, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k < points.size(); ++k) expected.emplace_back(glm::dot(points[k] - p, points[k] - p), k);
    std::sort(expected.begin(), expected.end());
    tree.nearest(p, 10, found);
    ASSERT_EQ(found.size(), 10u);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].squared, expected[i].first);
  }
}

TEST(PointTree, VisitsWhatLiesInTheBoxesThatAreEntered) {
  const std::vector<Point2> points = crowded_points(3000, 50);
  const PointTree tree(points);
  for (int i = 0; i < 50; ++i) {
    const Point2 p = points[static_cast<std::size_t>(i)];
    const double reach = i;
    std::vector<std::uint32_t> found, expected;
    tree.search(
        p, [&](double squared, const Rect&) { return squared <= reach * reach; },
        [&](double squared, std::uint32_t k) {
          EXPECT_EQ(squared, glm::dot(points[k] - p, points[k] - p));
          found.push_back(k);
        });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t k = 0; k < points.size(); ++k)
      if (glm::dot(points[k] - p, points[k] - p) <= reach * reach) expected.push_back(k);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    if (i < 5) {
      EXPECT_LT(found.size(), points.size() / 4);
    }
  }
}

TEST(PointTree, OfNoPointsHasNothingToVisit) {
  const PointTree tree(std::vector<Point2>{});
  tree.search(
      {0, 0}, [](double, const Rect&) { return true; }, [](double, std::uint32_t) { FAIL(); });
  EXPECT_EQ(tree.nearest({0, 0}), kNone);
}

}  // namespace
}  // namespace ligne
