// Places of rasters. Those of GeoTIFF: scripts/geo_tiff.txt.

#include "height_tools.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"
#include "tiff_text.hpp"

namespace ligne {
namespace {

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
