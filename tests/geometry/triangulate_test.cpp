#include "geometry/triangulate.hpp"

#include <chrono>

#include "base/no_index.hpp"
#include "clip_support.hpp"
#include "drawing/measures.hpp"
#include "geometry/delaunay.hpp"
#include "geometry/morton.hpp"
#include "geometry/polygons/merge_contours.hpp"
#include "geometry/predicates.hpp"
#include "main/script.hpp"
#include "polygon_shapes.hpp"
#include "support/line_text.hpp"

namespace ligne {
namespace {

using shapes::Contour;
using shapes::Flat;
using shapes::flatten;
using shapes::Polygon;
using shapes::rectangle;

/// Every triangle has area, the winding of the outer contour; areas add up; a sampled point lies in exactly one triangle
/// when it lies in the polygon and in none otherwise; the triangles merge to its contours.
void expect_partition(const Polygon& polygon, int samples = 400) {
  const Flat flat = flatten(polygon);
  const auto triangles = triangulate(flat.points, flat.contour_end);
  const double direction = test::area_of(polygon[0]) < 0 ? -1 : 1;
  double area = 0;
  Polygon parts;
  for (const auto& t : triangles) {
    const Contour& corners = parts.emplace_back(Contour{flat.points[t[0]], flat.points[t[1]], flat.points[t[2]]});
    EXPECT_EQ(orientation_sign(corners[0], corners[1], corners[2]), direction);
    area += std::abs(test::area_of(corners));
  }
  EXPECT_NEAR(area, test::area_within(polygon), 2e-12 * std::abs(test::area_of(polygon[0])));
  const Polygon merged = merge_contours(parts);
  EXPECT_LE(flatten(merged).points.size(), 2 * flat.points.size());  // more than it has, where one touches an edge
  Rect box;
  for (const Point2 p : polygon[0]) box.extend(p);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
  for (int i = 0; i < samples; ++i) {
    const Point2 p(x(random), y(random));
    const auto hits = std::ranges::count_if(parts, [&](const Contour& part) { return test::holds({part}, p); });
    EXPECT_EQ(test::holds(merged, p), hits == 1);
    EXPECT_EQ(hits, test::holds(polygon, p)) << "at " << p.x << ", " << p.y;
  }
}

/// Holds expect_partition() for every winding, a turned start, the mirror image and with each corner doubled.
void expect_partitions(const Polygon& polygon) {
  expect_partition(polygon);
  Polygon form = polygon;
  std::reverse(form[0].begin(), form[0].end());
  expect_partition(form);
  for (std::size_t i = 1; i < form.size(); i += 2) std::reverse(form[i].begin(), form[i].end());
  expect_partition(form);
  form = polygon;
  for (Contour& c : form) std::rotate(c.begin(), c.begin() + 1, c.end());
  expect_partition(form);
  form = polygon;
  for (Contour& c : form)
    for (Point2& p : c) p = {p.y, -p.x};
  expect_partition(form);
  for (Contour& c : form) {
    Contour doubled;
    for (const Point2 p : c) doubled.insert(doubled.end(), {p, p});
    c = doubled;
  }
  expect_partition(form);
}

Contour star(std::mt19937_64& random, int corners) {
  std::uniform_real_distribution<double> radius(0.05, 1);
  Contour c;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, r = radius(random);
    c.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return c;
}

std::string partition(const std::string& text) {
  const Polygon polygon = test::contours_of_text(text);
  expect_partitions(polygon);
  return std::to_string(polygon.size());
}

[[maybe_unused]] const bool polygons_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/geometry/polygons", {{"partition", partition}});

TEST(Triangulation, TriangleCountOfSimplePolygons) {
  std::mt19937_64 random(11);
  for (int corners = 3; corners < 60; ++corners) {
    const Flat flat = flatten({star(random, corners)});
    EXPECT_EQ(triangulate(flat.points, flat.contour_end).size(), static_cast<std::size_t>(corners - 2));
  }
  // A hole adds its corners and two for its bridge.
  const Flat flat = flatten({rectangle(0, 0, 9, 9), rectangle(1, 1, 2, 2), rectangle(4, 4, 6, 5)});
  EXPECT_EQ(triangulate(flat.points, flat.contour_end).size(), 4u + 2 * (4 + 2) - 2);
}

TEST(Triangulation, RandomStars) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 60; ++i) expect_partitions({star(random, 5 + 3 * i)});
}

TEST(Triangulation, ContoursWithoutAreaOrNotFiniteGiveNothing) {
  for (const Contour& contour :
       {Contour{{0, 0}, {1, 1}, {2, 2}}, Contour{{3, 3}, {3, 3}, {3, 3}}, Contour{{0, 0}, {1, 0}},
        Contour{{0, 0}, {5, 0}, {2, 0}, {7, 0}}, Contour{}, Contour{{0, 0}, {NAN, 0}, {1, 1}, {0, 1}}}) {
    const Flat flat = flatten({contour});
    EXPECT_TRUE(triangulate(flat.points, flat.contour_end).empty());
  }
  const Flat equal = flatten({rectangle(0, 0, 4, 4), rectangle(0, 0, 4, 4)});
  EXPECT_TRUE(triangulate(equal.points, equal.contour_end).empty()) << "a hole equal to the outer contour";
  const Flat flat = flatten({rectangle(0, 0, 4, 4), {{1, 1}, {2, 2}, {3, 3}}, {{1, 2}, {1, 2}}});
  EXPECT_EQ(triangulate(flat.points, flat.contour_end).size(), 2u);
}

TEST(Triangulation, VeryLargeAndVerySmallCoordinates) {
  for (const double size : {1e-300, 1e-30, 1e30, 1e300}) {
    const Flat flat = flatten({{{0, 0}, {size, 0}, {size, size}, {size / 2, size / 4}, {0, size}}});
    EXPECT_EQ(triangulate(flat.points, flat.contour_end).size(), 3u) << size;
  }
}

// No promise but termination and triangles of the right winding.
TEST(Triangulation, CrossingContoursTerminate) {
  std::mt19937_64 random(13);
  std::uniform_int_distribution<int> coordinate(0, 12), count(1, 4), corners(0, 14);
  for (int i = 0; i < 4000; ++i) {
    Polygon polygon(count(random));
    for (Contour& c : polygon)
      for (int k = corners(random); k > 0; --k) c.emplace_back(coordinate(random), coordinate(random));
    const Flat flat = flatten(polygon);
    for (const auto& t : triangulate(flat.points, flat.contour_end)) {
      const int sign = orientation_sign(flat.points[t[0]], flat.points[t[1]], flat.points[t[2]]);
      EXPECT_NE(sign, 0);
    }
  }
}

// Triangulations of points strewn evenly, in crowds, on grids, on circles and on lines.

__extension__ using Wide = __int128;

std::vector<LatticePoint> in_order(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end(), [](auto p, auto q) { return morton_key(p) < morton_key(q); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
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
  const std::vector<LatticePoint> hull = test::hull(points, true);
  double area = 0, hull_area = 0;
  for (std::size_t k = 2; k < hull.size(); ++k) hull_area += orientation(hull[0], hull[k - 1], hull[k]);
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
  EXPECT_EQ(mesh.triangles.size(), hull_area == 0 ? 0 : 2 * points.size() - 2 - hull.size());
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
