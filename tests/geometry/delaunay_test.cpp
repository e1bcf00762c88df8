// Triangulations of points strewn evenly, in crowds, on grids, on circles and on lines.

#include "geometry/delaunay.hpp"
#include "base/no_index.hpp"
#include "geometry/morton.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

__extension__ using Wide = __int128;

std::vector<LatticePoint> in_order(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end(), [](auto p, auto q) { return morton_key(p) < morton_key(q); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Twice the area of the convex hull, and the number of points on its border (Andrew's chains).
std::pair<double, std::size_t> hull_of(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end());
  double area = 0;
  std::size_t on_border = 0;
  for (int half = 0; half < 2; ++half) {
    std::vector<LatticePoint> chain;
    for (const LatticePoint& p : points) {
      while (chain.size() > 1 && orientation(chain[chain.size() - 2], chain.back(), p) < 0) chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) area += orientation(chain[0], chain[k], chain[k + 1]);
    on_border += chain.size() - 1;
    std::reverse(points.begin(), points.end());
  }
  return {area, on_border};
}

/// Whether d lies within the circle through a, b, c: by the determinant of four rows, in 128 bits.
bool within_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto square = [&](LatticePoint p) {
    const Wide x = Wide{p.x} - d.x, y = Wide{p.y} - d.y;
    return x * x + y * y;
  };
  const auto minor = [&](LatticePoint p, LatticePoint q) {
    return (Wide{p.x} - d.x) * (Wide{q.y} - d.y) - (Wide{p.y} - d.y) * (Wide{q.x} - d.x);
  };
  return square(a) * minor(b, c) - square(b) * minor(a, c) + square(c) * minor(a, b) > 0;
}

void expect_delaunay(const std::vector<LatticePoint>& points) {
  const Delaunay mesh = triangulate_delaunay(points);
  ASSERT_EQ(mesh.triangles.size(), mesh.neighbours.size());
  const auto [hull_area, on_border] = hull_of(points);
  double area = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const double turned = orientation(points[v[0]], points[v[1]], points[v[2]]);
    ASSERT_GT(turned, 0) << t;
    area += turned;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = mesh.neighbours[t][k];
      if (beyond == kNone) continue;
      const auto& there = mesh.neighbours[beyond];
      const auto side = static_cast<std::size_t>(std::find(there.begin(), there.end(), t) - there.begin());
      ASSERT_LT(side, 3u);
      const auto& w = mesh.triangles[beyond];
      ASSERT_EQ(w[side], v[(k + 1) % 3]);
      ASSERT_EQ(w[(side + 1) % 3], v[k]);
      EXPECT_FALSE(within_circle(points[v[0]], points[v[1]], points[v[2]], points[w[(side + 2) % 3]])) << t;
    }
  }
  EXPECT_EQ(area, hull_area);
  EXPECT_EQ(mesh.triangles.size(), hull_area == 0 ? 0 : 2 * points.size() - 2 - on_border);
}

TEST(Delaunay, PointsStrewnEvenly) {
  std::mt19937 random(20);
  for (const std::int32_t size : {3, 30, 3000, kLatticeLimit})
    for (const std::size_t count : {2, 3, 4, 5, 6, 7, 20, 5000}) {
      std::uniform_int_distribution<std::int32_t> at(-size, size);
      std::vector<LatticePoint> points(count);
      for (LatticePoint& p : points) p = {at(random), at(random)};
      SCOPED_TRACE(std::to_string(count) + " points within " + std::to_string(size));
      expect_delaunay(in_order(points));
    }
}

/// A part of the plane that holds a single point has no edge of its own.
TEST(Delaunay, CrowdsAndSinglePoints) {
  std::mt19937 random(21);
  std::normal_distribution<double> crowd(0, 40);
  std::vector<LatticePoint> points{{-kLatticeLimit, -kLatticeLimit}, {kLatticeLimit, kLatticeLimit}, {kLatticeLimit, -7}};
  for (int k = 0; k < 2000; ++k) {
    points.push_back({1000 + std::int32_t(crowd(random)), -kLatticeLimit / 2 + std::int32_t(crowd(random))});
    points.push_back({(1 << (k % 25)) - 1, (1 << (k % 23)) - k});
  }
  expect_delaunay(in_order(points));
}

TEST(Delaunay, GridsAndCircles) {
  std::vector<LatticePoint> grid, circle;
  for (std::int32_t i = 0; i < 40; ++i)
    for (std::int32_t j = 0; j < 25; ++j) grid.push_back({i * 1000 - 20'000, j * 1000 - 3});
  for (int k = 0; k < 360; ++k) {
    const double angle = k * std::acos(-1) / 180;
    circle.push_back({std::int32_t(std::lround(1e7 * std::cos(angle))), std::int32_t(std::lround(1e7 * std::sin(angle)))});
  }
  expect_delaunay(in_order(grid));
  expect_delaunay(in_order(circle));
}

TEST(Delaunay, LinesHaveNoTriangles) {
  for (const LatticePoint step : {LatticePoint{1, 0}, {0, 1}, {3, 5}, {3, -5}, {-1, 1}}) {
    std::vector<LatticePoint> line;
    for (std::int32_t k = -50; k < 50; ++k) line.push_back({k * step.x, k * step.y});
    EXPECT_TRUE(triangulate_delaunay(in_order(line)).triangles.empty());
    line.push_back({7, 4});
    expect_delaunay(in_order(line));
  }
}

}  // namespace
}  // namespace ligne
