// Boxes that hang together, against the comparison of every pair.

#include "geometry/connected_boxes.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <vector>

namespace ligne {
namespace {

DisjointSets by_pairs(const std::vector<AxisBox>& boxes) {
  DisjointSets sets(boxes.size());
  const auto has_inside = [](const AxisBox& b) { return b.x0 < b.x1 && b.y0 < b.y1; };
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t k = 0; k < i; ++k) {
      const AxisBox &a = boxes[i], &b = boxes[k];
      if (has_inside(a) && has_inside(b) && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1) sets.join(i, k);
    }
  }
  return sets;
}

TEST(ConnectedBoxes, AreThoseOfEveryPair) {
  std::mt19937 random(7);
  std::size_t sets_in_all = 0;
  for (int round = 0; round < 3000; ++round) {
    // Whole numbers, so that many borders coincide; from boxes that stand alone to one heap.
    const int n = 1 + static_cast<int>(random() % 40), side = 4 + static_cast<int>(random() % 60);
    std::vector<AxisBox> boxes;
    for (int i = 0; i < n; ++i) {
      const double x = random() % side, y = random() % side;
      boxes.push_back({x, y, x + random() % 7, y + random() % 7});
    }
    DisjointSets found = connect_boxes(boxes), expected = by_pairs(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      ASSERT_EQ(found.find(i), expected.find(i)) << "round " << round << ", box " << i;
      sets_in_all += found.find(i) == i;
    }
  }
  EXPECT_GT(sets_in_all, 3000u);
}

TEST(ConnectedBoxes, OfNothing) { connect_boxes({}); }

TEST(ConnectedBoxes, ACrowdCostsNoMoreThanOthers) {
  std::vector<AxisBox> boxes;
  constexpr int kBoxes = 200'000;
  for (int i = 0; i < kBoxes; ++i) boxes.push_back({1e-6 * i, 1e-6 * i, 1 + 1e-6 * i, 1 + 1e-6 * i});
  const auto start = std::chrono::steady_clock::now();
  DisjointSets sets = connect_boxes(boxes);
  // Two by two these are 2 10^10 pairs, which take minutes.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(sets.find(i), 0u);
}

}  // namespace
}  // namespace ligne
