#include "drawing/point_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace ligne {
namespace {

TEST(PointTree, VisitsWhatLiesInTheBoxesThatAreEntered) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-50, 50);  // many points in one place
  std::vector<LatticePoint> points(3000);
  for (LatticePoint& p : points) p = {place(random), place(random)};
  const PointTree tree(points);
  for (int i = 0; i < 50; ++i) {
    const LatticePoint p{place(random), place(random)};
    const double reach = i;
    std::vector<std::uint32_t> found, expected;
    tree.search(
        p, [&](const PointBox& box) { return box.squared_distance(p) <= reach * reach; },
        [&](std::uint32_t k) { found.push_back(k); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      if (PointBox{points[k], points[k]}.squared_distance(p) <= reach * reach) expected.push_back(k);
    }
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    if (i < 5) {
      EXPECT_LT(found.size(), points.size() / 4);
    }
  }
}

TEST(PointTree, OfNoPointsHasNothingToVisit) {
  PointTree(std::vector<LatticePoint>{})
      .search(
          {0, 0}, [](const PointBox&) { return true; }, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace ligne
