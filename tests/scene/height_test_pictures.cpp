#include <thread>

#include "height_tools.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"
#include "tiff_text.hpp"

namespace ligne {
namespace {

using namespace height_test;

TEST(PointGrid, ScatteredPointsAreTriangulated) {
  // A plane, whatever the triangles; nothing beyond the convex hull.
  std::string text = "x,y,z\n";
  for (int k = 0; k < 200; ++k) {
    const double x = k * 37 % 101 + 0.25 * (k % 3), y = k * 61 % 97 + 0.125 * (k % 5);
    text += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(2 * x - y + 1) + "\n";
  }
  Warnings warnings;
  const auto source = grid(text, warnings);
  ASSERT_TRUE(source->function());
  std::vector<double> z(source->x().size());
  std::size_t inside = 0;
  for (std::size_t j = 0; j < source->y().size(); ++j) {
    source->read_row(j, z);
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (std::isnan(z[i])) continue;
      EXPECT_NEAR(z[i], 2 * source->x()[i] - source->y()[j] + 1, 2e-5);
      ++inside;
    }
  }
  EXPECT_GT(inside, z.size() * source->y().size() * 7 / 10);
  EXPECT_LT(inside, z.size() * source->y().size());
}

TEST(GridFile, WithoutAFile) {
  Warnings warnings;
  EXPECT_EQ(error_line([&] { read_grid(std::filesystem::path("absent.csv"), warnings); }),
            "absent.csv: there is no such file");
}

double value(const std::string& formula, double x, double y) {
  return heights_of(*formula_heights(formula, {x, x + 1}, {y, y + 1}))[0][0];
}

TEST(FormulaHeights, Functions) {
  const double x = 0.3, y = -0.7;
  const std::pair<const char*, double (*)(double)> of_x[] = {
      {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},     {"asin", std::asin}, {"acos", std::acos},
      {"atan", std::atan}, {"sinh", std::sinh}, {"cosh", std::cosh},   {"tanh", std::tanh}, {"sqrt", std::sqrt},
      {"exp", std::exp},   {"log", std::log},   {"log10", std::log10}, {"log2", std::log2}, {"ln", std::log}};
  for (const auto& [name, function] : of_x) EXPECT_DOUBLE_EQ(value(std::string(name) + " ( x )", x, y), function(x)) << name;
  EXPECT_DOUBLE_EQ(value("atan2(y, x)", x, y), std::atan2(y, x));
  EXPECT_EQ(value("e", 0, 0), std::numbers::e);
}

TEST(FormulaHeights, SameFromSeveralThreads) {
  std::vector<double> positions(50);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = 0.1 * static_cast<double>(i);
  const auto source = formula_heights("sin(x)*cos(y) + r - theta", positions, positions);
  const auto expected = heights_of(*source);
  std::vector<std::vector<std::vector<double>>> found(4);
  std::vector<std::thread> threads;
  for (auto& heights : found) threads.emplace_back([&] { heights = heights_of(*source); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& heights : found) EXPECT_EQ(heights, expected);
}

// Places of rasters. Those of GeoTIFF: scripts/geo_tiff.txt.

using namespace height_test;

TEST(RasterPlacement, RowsAndColumnsInEveryDirection) {
  for (int turn = 0; turn < 8; ++turn) {
    RasterTransform t;
    t.at = {100, 200};
    const double s = turn & 1 ? -3 : 3, u = turn & 2 ? -2 : 2;
    t.per_column = turn & 4 ? Point2{0, s} : Point2{s, 0};
    t.per_row = turn & 4 ? Point2{u, 0} : Point2{0, u};
    const auto placed = place_raster(t, 4, 3);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->turned_degrees, 0);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const Point2 p = t.at + (column + 0.5) * t.per_column + (row + 0.5) * t.per_row;
        const auto i = std::find(placed->x.begin(), placed->x.end(), p.x) - placed->x.begin();
        const auto j = std::find(placed->y.begin(), placed->y.end(), p.y) - placed->y.begin();
        EXPECT_EQ(placed->order.begin + i * placed->order.step_x + j * placed->order.step_y, row * 4 + column) << turn;
      }
    }
  }
}

TEST(RasterPlacement, TurnedRastersKeepTheirLengths) {
  RasterTransform t;
  t.per_column = {4, 3};
  t.per_row = {3, -4};
  Warnings warnings;
  const auto placed = place_raster(t, 10, 5);
  ASSERT_TRUE(placed);
  EXPECT_NEAR(placed->x[1] - placed->x[0], 5, 1e-12);
  EXPECT_NEAR(placed->y[1] - placed->y[0], 5, 1e-12);
  EXPECT_FALSE(placed->sheared);
  warn_of_turned_raster(*placed, warnings);
  EXPECT_EQ(warnings.lines().front().rfind("1 raster turned by 36.8699 degrees against x and y", 0), 0u);
  t.per_row = {3, 4};
  EXPECT_TRUE(place_raster(t, 10, 5)->sheared);
  t.per_row = {8, 6};
  EXPECT_FALSE(place_raster(t, 10, 5)) << "a line";
}

#ifdef LIGNE_HAVE_TIFF

TEST(GeoTiff, WorldFileBesideIt) {
  const test::TemporaryFolder folder;
  folder.write("a.tif", tiff_of("f4 3 2 1 1 2 3 4 5 6"));
  Warnings warnings;
  folder.write("a.tfw", "10\n0\n0\n-20\n505\n890\n");
  InputFiles opened;
  expect_grid(*read_grid(folder / "a.tif", warnings, &opened), {505, 515, 525}, {870, 890}, {{4, 5, 6}, {1, 2, 3}});
  EXPECT_EQ(opened.size(), 2u);
  EXPECT_TRUE(warnings.lines().empty());
  folder.write("a.tfw", "10\n0\nnorth\n");
  expect_grid(*read_grid(folder / "a.tif", warnings, &opened), {0, 1, 2}, {0, 1}, {{4, 5, 6}, {1, 2, 3}});
  EXPECT_EQ(warnings.lines().front().rfind("1 world file without six numbers", 0), 0u);
}

#endif

}  // namespace
}  // namespace ligne
