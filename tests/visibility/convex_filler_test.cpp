// Filling in fixed point: the same columns as scan conversion in real numbers, neighbours without gap or overlap.

#include "visibility/common/convex_filler.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "visibility/common/scan_conversion.hpp"

namespace ligne {
namespace {

struct Row {
  std::int64_t line, from, to;
  friend bool operator==(const Row&, const Row&) = default;
};

std::vector<Row> rows_of(const std::vector<std::array<double, 2>>& corners, std::int64_t first = 0,
                         std::int64_t end = 1000) {
  std::vector<FixedCorner> fixed;
  for (const auto& [u, v] : corners) fixed.push_back(FixedCorner::at(u, v));
  std::vector<Row> rows;
  ConvexFiller filler;
  filler.fill(fixed, first, end, [&](std::int64_t line, std::int64_t from, std::int64_t to) {
    if (from < to) rows.push_back({line, from, to});
  });
  return rows;
}

TEST(ConvexFiller, SquareWithItsCornersOnCentres) {
  EXPECT_EQ(rows_of({{1, 1}, {5, 1}, {5, 3}, {1, 3}}), (std::vector<Row>{{1, 1, 5}, {2, 1, 5}}));
  EXPECT_EQ(rows_of({{1, 3}, {5, 3}, {5, 1}, {1, 1}}), (std::vector<Row>{{1, 1, 5}, {2, 1, 5}})) << "turned round";
}

TEST(ConvexFiller, HexagonAndNothing) {
  EXPECT_EQ(rows_of({{2, 0}, {4, 0}, {6, 2}, {4, 4}, {2, 4}, {0, 2}}),
            (std::vector<Row>{{0, 2, 4}, {1, 1, 5}, {2, 0, 6}, {3, 1, 5}}));
  EXPECT_TRUE(rows_of({{1, 2.2}, {5, 2.4}, {9, 2.9}}).empty());
  EXPECT_TRUE(rows_of({}).empty());
}

TEST(ConvexFiller, LinesOfABandAreThoseOfTheWhole) {
  const std::vector<std::array<double, 2>> corners{{-3, -7.5}, {41.3, 20.2}, {10, 96.7}};
  const std::vector<Row> whole = rows_of(corners, -100, 1000);
  std::vector<Row> parts = rows_of(corners, -100, 13);
  for (const Row& r : rows_of(corners, 13, 1000)) parts.push_back(r);
  EXPECT_EQ(parts, whole);
  EXPECT_LT(whole.front().line, 0);
}

/// The largest places and the flattest side.
TEST(ConvexFiller, NothingOverflows) {
  const std::vector<Row> rows = rows_of({{-30000, 0.99999}, {30000, 1.00002}, {30000, 2.5}, {-30000, 2.5}}, 0, 32000);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1], (Row{2, -30000, 30000}));
  EXPECT_GE(rows[0].from, -30000);
  EXPECT_LE(rows[0].to, 30000);
}

TEST(ConvexFiller, AgreesWithScanConversion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 300);
  std::size_t columns = 0, unlike = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::array<double, 2>> corners(3);
    for (auto& c : corners) c = {place(random), place(random)};
    std::map<std::int64_t, Row> expected;
    std::vector<GridPoint> points;
    for (const auto& [u, v] : corners) points.push_back({u, v, 0});
    for (const PolygonRun& r : scan_polygon(points, std::vector<std::uint32_t>{3}, 300)) {
      expected[r.line] = {r.line, std::llround(std::ceil(r.u0)), std::llround(std::ceil(r.u1))};
    }
    for (const Row& r : rows_of(corners, 0, 300)) {
      const Row e = expected.contains(r.line) ? expected[r.line] : Row{r.line, r.from, r.from};
      columns += static_cast<std::size_t>(r.to - r.from);
      unlike += static_cast<std::size_t>(std::abs(r.from - e.from) + std::abs(r.to - e.to));
    }
  }
  // Corners are rounded to 2^-16 of a pixel.
  EXPECT_LT(unlike, columns / 100'000);
}

/// A plate of triangles whose corners are moved at random: each centre is in one of them.
TEST(ConvexFiller, NeighboursShareNothingAndLeaveNothingOut) {
  constexpr int kCells = 24, kSize = 97;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> move(-0.9, 0.9);
  std::vector<std::array<double, 2>> corner;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const bool inside = i > 0 && j > 0 && i < kCells && j < kCells;
      const double step = double(kSize) / kCells;
      corner.push_back({i * step + (inside ? move(random) : 0), j * step + (inside ? move(random) : 0)});
    }
  }
  std::vector<int> painted(kSize * kSize, 0);
  ConvexFiller filler;
  const auto fill = [&](int a, int b, int c) {
    std::vector<FixedCorner> t;
    for (const int k : {a, b, c}) t.push_back(FixedCorner::at(corner[std::size_t(k)][0], corner[std::size_t(k)][1]));
    filler.fill(t, 0, kSize, [&](std::int64_t line, std::int64_t from, std::int64_t to) {
      for (std::int64_t i = from; i < to; ++i) ++painted[std::size_t(line * kSize + i)];
    });
  };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const int a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
      fill(a, b, c);
      fill(b, d, c);
    }
  }
  for (const int n : painted) ASSERT_EQ(n, 1);
}

}  // namespace
}  // namespace ligne
