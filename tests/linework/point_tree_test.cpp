/// The tree of points against a look at all points.

#include "linework/point_tree.hpp"
#include "geometry/point.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

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
    const auto is_near = [&](std::uint32_t k) {
      return PointBox<2>{points[k], points[k]}.squared_distance(p) <= reach * reach;
    };
    std::vector<std::uint32_t> found, expected;
    tree.search_from(
        p,
        [&](std::uint32_t node, double squared) {
          EXPECT_EQ(squared, tree.box(node).squared_distance(p));
          return squared <= reach * reach;
        },
        [&](std::uint32_t begin, std::uint32_t end) {
          for (; begin < end; ++begin) found.push_back(tree.order()[begin]);
        });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t k = 0; k < points.size(); ++k)
      if (is_near(k)) expected.push_back(k);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    if (i < 5) {
      EXPECT_LT(found.size(), points.size() / 4);
    }
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

TEST(PointTree, OfNoPointsHasNothingToVisit) {
  PointTree<2>(std::vector<TreePoint<2>>{})
      .search_from(
          Point2(0, 0), [](std::uint32_t, double) { return true; }, [](std::uint32_t, std::uint32_t) { FAIL(); });
  PointTree<2>(std::vector<TreePoint<2>>{})
      .search([](const PointBox<2>&) { return true; }, [](std::uint32_t, std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace ligne
