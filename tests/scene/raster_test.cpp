// Positions, scales, holes and bands of GeoTIFF.

#include "height_tools.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"
#include "tiff_builder.hpp"

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

const std::vector<float> kSix{1, 2, 3, 4, 5, 6};
constexpr std::uint16_t kUnsigned = 1, kSigned = 2, kFloat = 3;

std::vector<std::string> warnings_of(const TiffBuilder& tiff, const GridChoice& choice = {}) {
  Warnings warnings;
  read_grid(reader_test::bytes_of(tiff.bytes()), "M", warnings, {}, nullptr, choice);
  return warnings.lines();
}

TEST(GeoTiff, SouthUpIsNotMirrored) {
  TiffBuilder tiff(3, 2, kSix, kFloat);
  tiff.doubles(34264, {10, 0, 0, 500, 0, 10, 0, 800, 0, 0, 0, 0, 0, 0, 0, 1});
  expect_grid(*grid(tiff.bytes()), {505, 515, 525}, {805, 815}, {{1, 2, 3}, {4, 5, 6}});
  tiff.doubles(34264, {0, 10, 0, 500, 10, 0, 0, 800, 0, 0, 0, 0, 0, 0, 0, 1});
  expect_grid(*grid(tiff.bytes()), {505, 515}, {805, 815, 825}, {{1, 4}, {2, 5}, {3, 6}});
  tiff.shorts(34735, {1, 1, 0, 1, 1025, 0, 1, 2});  // pixels are points
  expect_grid(*grid(tiff.bytes()), {500, 510}, {800, 810, 820}, {{1, 4}, {2, 5}, {3, 6}});
}

TEST(GeoTiff, TurnedAndTiedRastersWarn) {
  TiffBuilder turned(3, 2, kSix, kFloat);
  turned.doubles(34264, {4, 3, 0, 500, 3, -4, 0, 800, 0, 0, 0, 0, 0, 0, 0, 1});
  EXPECT_EQ(warnings_of(turned).size(), 1u);
  TiffBuilder tied(3, 2, kSix, kFloat);
  tied.doubles(33922, {0, 0, 0, 1, 1, 0, 3, 2, 0, 2, 2, 0});
  EXPECT_EQ(warnings_of(tied), std::vector<std::string>{"left out: 2 ground control points, which gdalwarp applies"});
}

TEST(GeoTiff, ScaleAndOffset) {
  TiffBuilder tiff(2, 2, std::vector<std::int16_t>{10, 20, -999, 40}, kSigned);
  tiff.text(42113, "-999")
      .text(42112,
            "<GDALMetadata><Item name=\"OFFSET\" sample=\"0\" role=\"offset\">30</Item>"
            "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>"
            "<Item name=\"SCALE\" sample=\"1\" role=\"scale\">7</Item></GDALMetadata>");
  expect_grid(*grid(tiff.bytes()), {0, 1}, {0, 1}, {{kNaN, 50}, {35, 40}});
}

TEST(GeoTiff, MasksMakeHoles) {
  TiffBuilder tiff(3, 2, kSix, kFloat);
  TiffBuilder mask(3, 2, std::vector<std::uint8_t>{0b10100000, 0b11000000}, kUnsigned);
  mask.longs(254, {4}).shorts(258, {1}).shorts(262, {4});
  TiffBuilder overview(1, 1, std::vector<float>{1}, kFloat);
  overview.longs(254, {1});
  tiff.then(overview).then(mask);
  expect_grid(*grid(tiff.bytes()), {0, 1, 2}, {0, 1}, {{4, 5, kNaN}, {1, kNaN, 3}});
  TiffBuilder pages(3, 2, kSix, kFloat);
  pages.then(TiffBuilder(3, 2, kSix, kFloat));
  EXPECT_EQ(warnings_of(pages), std::vector<std::string>{"left out: 1 page after the first"});
}

TEST(GeoTiff, VoidsWithoutNoData) {
  TiffBuilder tiff(2, 2, std::vector<std::int16_t>{10, 20, -32768, 40}, kSigned);
  Warnings warnings;
  expect_grid(*grid(tiff.bytes(), warnings), {0, 1}, {0, 1}, {{kNaN, 40}, {10, 20}});
  EXPECT_EQ(warnings.lines(), std::vector<std::string>{"1 height of -32768 read as NODATA"});
  TiffBuilder floats(2, 2, std::vector<float>{10, -3.4028235e38f, 30, 40}, kFloat);
  EXPECT_EQ(warnings_of(floats), std::vector<std::string>{"1 height below -1e38 read as NODATA"});
}

TEST(GeoTiff, NoDataOfFloatsHasOtherDigits) {
  TiffBuilder floats(2, 2, std::vector<float>{0.1f, 20, 30, 40}, kFloat);
  expect_grid(*grid(floats.text(42113, "0.1").bytes()), {0, 1}, {0, 1}, {{30, 40}, {kNaN, 20}});
  TiffBuilder whole(2, 2, std::vector<std::int32_t>{16777216, 16777217, 30, 40}, kSigned);
  expect_grid(*grid(whole.text(42113, "16777217").bytes()), {0, 1}, {0, 1}, {{30, 40}, {16777216, kNaN}});
}

TEST(GeoTiff, BandsAreChosen) {
  TiffBuilder tiff(2, 2, std::vector<std::int16_t>{1, 10, 2, 20, 3, 30, 4, 40}, kSigned, 2);
  EXPECT_EQ(warnings_of(tiff), std::vector<std::string>{"left out: 1 band after the first, which --band N chooses"});
  GridChoice second;
  second.band = 2;
  Warnings warnings;
  const std::string file = tiff.bytes();
  const auto bytes = reader_test::bytes_of(file);
  expect_grid(*read_grid(bytes, "M", warnings, {}, nullptr, second), {0, 1}, {0, 1}, {{30, 40}, {10, 20}});
  EXPECT_TRUE(warnings.lines().empty());
  second.band = 3;
  EXPECT_EQ(error_line([&] { read_grid(bytes, "M", warnings, {}, nullptr, second); }), "M: has 2 bands, but no band 3");
  EXPECT_EQ(error_line([&] { read_grid(reader_test::bytes_of("1,2\n3,4\n"), "M", warnings, {}, nullptr, second); }),
            "M: has one band; --band works for GeoTIFF and the formats of GDAL");
  tiff.shorts(338, {2});  // transparency
  EXPECT_TRUE(warnings_of(tiff).empty());
}

TEST(GeoTiff, WorldFileBesideIt) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "ligne_world_file";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.tif", std::ios::binary) << TiffBuilder(3, 2, kSix, kFloat).bytes();
  Warnings warnings;
  std::ofstream(folder / "a.tfw") << "10\n0\n0\n-20\n505\n890\n";
  InputFiles opened;
  expect_grid(*read_grid(folder / "a.tif", warnings, &opened), {505, 515, 525}, {870, 890}, {{4, 5, 6}, {1, 2, 3}});
  EXPECT_EQ(opened.size(), 2u);
  EXPECT_TRUE(warnings.lines().empty());
  std::ofstream(folder / "a.tfw") << "10\n0\nnorth\n";
  expect_grid(*read_grid(folder / "a.tif", warnings, &opened), {0, 1, 2}, {0, 1}, {{4, 5, 6}, {1, 2, 3}});
  EXPECT_EQ(warnings.lines().front().rfind("1 world file without six numbers", 0), 0u);
  std::filesystem::remove_all(folder);
}

TEST(GeoTiff, WhatIsNotReadNamesTheCommand) {
  Warnings warnings;
  TiffBuilder halves(2, 2, std::vector<std::uint16_t>{1, 2, 3, 4}, kFloat);
  EXPECT_EQ(grid_error(halves.bytes()),
            "M: is a TIFF file with values of 16 bits of kind float, which is not read; gdal_translate -ot Float32 -co "
            "COMPRESS=DEFLATE makes one that is");
  TiffBuilder packed(2, 2, std::vector<std::uint16_t>{1, 2, 3, 4}, kUnsigned);
  EXPECT_NE(grid_error(packed.shorts(259, {50002}).bytes()).find("gdal_translate"), std::string::npos);  // JPEG XL
}

#endif

}  // namespace
}  // namespace ligne
