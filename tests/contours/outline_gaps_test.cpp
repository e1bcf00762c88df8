// Outlines before the empty sheet have no gaps, however rough the mesh is.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "contours/parametric_mesh.hpp"

namespace ligne::test {
namespace {

constexpr int kCellsPerMm = 4, kColumns = 297 * kCellsPerMm, kRows = 210 * kCellsPerMm;

Point2 center(int column, int row) { return {(column + 0.5) / kCellsPerMm, (row + 0.5) / kCellsPerMm}; }

/// The cells of the page that faces cover, row by row.
std::vector<char> covered_cells(const Scene& scene, const View& view) {
  std::vector<char> covered(std::size_t{kColumns} * kRows, 0);
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const auto corners = scene.faces.contour(f, 0);
    std::array<Point2, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = page_point(view, scene.vertices[corners[c]]);
    const Point2 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    for (int row = int(low.y * kCellsPerMm); row <= int(high.y * kCellsPerMm); ++row) {
      for (int column = int(low.x * kCellsPerMm); column <= int(high.x * kCellsPerMm); ++column) {
        const Point2 at = center(column, row);
        int left = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const Point2 d = p[(c + 1) % 3] - p[c], e = at - p[c];
          left += d.x * e.y - d.y * e.x > 0;
        }
        if (left % 3 == 0) covered[std::size_t(row) * kColumns + std::size_t(column)] = 1;
      }
    }
  }
  return covered;
}

/// How far the rims of what is covered are from the nearest line, at the farthest.
double farthest_rim(const std::vector<char>& covered, const Polylines& lines) {
  double farthest = 0;
  for (int row = 1; row + 1 < kRows; ++row) {
    for (int column = 1; column + 1 < kColumns; ++column) {
      const char* cell = &covered[std::size_t(row) * kColumns + std::size_t(column)];
      if (!cell[0] || (cell[1] && cell[-1] && cell[kColumns] && cell[-kColumns])) continue;
      const Point2 p = center(column, row);
      double best = 1000;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t k = 1; k < lines[i].size(); ++k) {
          const Point2 a = lines[i][k - 1], d = lines[i][k] - a;
          const double square = glm::dot(d, d);
          const double t = square > 0 ? std::clamp(glm::dot(p - a, d) / square, 0.0, 1.0) : 0;
          best = std::min(best, glm::length(a + t * d - p));
        }
      }
      farthest = std::max(farthest, best);
    }
  }
  return farthest;
}

/// The farthest that a rim is from a line, of a body with 2 n by n cells and vertices up to `rough` beside their place, in
/// mm on the page, nearly; a vertex alone may stand out from its line by twice as much.
double widest_gap(double rough, int n, std::uint32_t seed) {
  Scene scene = uneven_mesh(test_surfaces()[seed % 5], 2 * n, n, 0.3, seed);
  std::mt19937 random(seed);
  const auto unit = [&] { return 2 * double(random()) / double(std::mt19937::max()) - 1; };
  for (Point3& v : scene.vertices) {
    const double x = unit(), y = unit(), z = unit();
    v += rough * Point3{x, y, z};
  }
  const DrawnOutlines drawn = draw_outlines(scene, {-1, 1, -1});
  return farthest_rim(covered_cells(scene, drawn.view), drawn.lines);
}

TEST(OutlineGaps, AreNoneOnRoughBodies) {
  for (const std::uint32_t seed : {7, 12, 13, 18}) EXPECT_LT(widest_gap(0.4, 60, seed), 0.9) << "seed " << seed;
}

TEST(OutlineGaps, AreNoneBetweenAContourAndAnOutlineOfTheMesh) {
  EXPECT_LT(widest_gap(0.7, 40, 106), 0.9);
  EXPECT_LT(widest_gap(0.5, 30, 99), 0.9);
}

}  // namespace
}  // namespace ligne::test
