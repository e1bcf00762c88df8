#include <thread>

#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

const std::vector<std::vector<double>> kOneMissing{{1, 2, 3}, {4, kNaN, 6}, {7, 8, 9}, {10, 11, 12}};

TEST(PointGrid, ShuffledAndIncompleteGridsHaveHoles) {
  Warnings warnings;
  const std::string rows[] = {"0 0 1", "1 0 2", "2 0 3",  "0 1 4",  "2 1 6", "0 2 7",
                              "1 2 8", "2 2 9", "0 3 10", "1 3 11", "2 3 12"};
  std::string in_order, shuffled;
  for (std::size_t k = 0; k < std::size(rows); ++k) {
    in_order += rows[k] + "\n";
    shuffled += rows[k * 7 % std::size(rows)] + "\n";
  }
  expect_grid(*grid(in_order, warnings), {0, 1, 2}, {0, 1, 2, 3}, kOneMissing);
  expect_grid(*grid(shuffled, warnings), {0, 1, 2}, {0, 1, 2, 3}, kOneMissing);
  EXPECT_EQ(warnings.counts().size(), 0u);
}

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

struct Summary {
  double low = 1e300, high = -1e300;
  std::size_t holes = 0;
};

Summary summary_of(const HeightSource& source) {
  Summary summary;
  for (const auto& row : heights_of(source)) {
    for (const double z : row) {
      summary.holes += std::isnan(z);
      summary.low = std::fmin(summary.low, z);
      summary.high = std::fmax(summary.high, z);
    }
  }
  return summary;
}

TEST(SharedGrids, HaveTheirSizesAndHeights) {
  LIGNE_NEED_MODELS(folder);
  struct Row {
    const char* file;
    std::size_t columns, rows;
    double low, high, within;
    bool has_holes;
  };
  Warnings warnings;
  for (const Row& row : {Row{"west_bijou_gully.asc", 43, 89, 1680.8, 1725.4, 0.05, true},
                         Row{"jacksboro_dem_16bit.png", 403, 344, 236, 1076, 0, false}}) {
    const auto source = read_grid(folder / row.file, warnings);
    const Summary summary = summary_of(*source);
    EXPECT_EQ(source->x().size(), row.columns) << row.file;
    EXPECT_EQ(source->y().size(), row.rows) << row.file;
    EXPECT_NEAR(summary.low, row.low, row.within) << row.file;
    EXPECT_NEAR(summary.high, row.high, row.within) << row.file;
    EXPECT_EQ(summary.holes > 0, row.has_holes) << row.file;
  }
  const auto gully = read_grid(folder / "west_bijou_gully.asc", warnings);
  EXPECT_EQ(gully->x().front(), 559706.5);
  EXPECT_EQ(gully->y().front(), 4380221.5);
}

TEST(SharedGrids, RunoutIsAGeoTiff) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  const std::filesystem::path file = folder / "runout_dem_float32.tif";
#if defined(LIGNE_HAVE_TIFF) || defined(LIGNE_HAVE_GDAL)
  const auto source = read_grid(file, warnings);
  EXPECT_EQ(source->x().size(), 80u);
  EXPECT_EQ(source->y().size(), 122u);
  EXPECT_DOUBLE_EQ(source->x()[1] - source->x()[0], 10);
  EXPECT_GT(summary_of(*source).low, -9999);
  EXPECT_EQ(source->unit(), GroundUnit::same);
#else
  EXPECT_EQ(error_line([&] { read_grid(file, warnings); }),
            file.string() + ": needs GDAL (a GeoTIFF, HDF5 or netCDF file), and this ligne is built without it");
#endif
}

#ifdef LIGNE_HAVE_TIFF
TEST(TiffGrid, StripsTilesAndTheirPlaces) {
  Warnings warnings;
  const std::filesystem::path folder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/fuzz/corpus/tiff";
  const auto degrees = read_grid(folder / "strips_float32.tif", warnings);
  expect_grid(*degrees, {10.25, 10.75, 11.25}, {49.625, 49.875}, {{4, kNaN, 6}, {1.5, 2, 3}});
  EXPECT_EQ(degrees->unit(), GroundUnit::degrees);
  const auto points = read_grid(folder / "points_int16_big_endian.tif", warnings);
  expect_grid(*points, {500, 530}, {870, 900}, {{3, 4}, {1, -2}});
  EXPECT_EQ(points->unit(), GroundUnit::same);
  const auto tiles = read_grid(folder / "tiles_deflate_uint16.tif", warnings);
  std::vector<double> row(20);
  tiles->read_row(0, row);
  EXPECT_EQ(row[19], 1719) << "the last row stands first";
  const auto doubles = read_grid(folder / "float64_deflate.tif", warnings);
  doubles->read_row(2, std::span(row).first(4));
  EXPECT_EQ(row[3], 1e10 + 3);
  const auto lzw = read_grid(folder / "strips_lzw_int16.tif", warnings);
  lzw->read_row(3, std::span(row).first(5));
  EXPECT_EQ(row[0], -3) << "the last row stands first";
  lzw->read_row(0, std::span(row).first(5));
  EXPECT_EQ(row[4], 301);
  const auto error = [&](const char* file) { return error_line([&] { read_grid(folder / file, warnings); }); };
  EXPECT_NE(error("truncated.tif").find("is a TIFF file that can not be read"), std::string::npos);
  EXPECT_NE(error("header_lies.tif").find("is a TIFF file that can not be read"), std::string::npos);
  EXPECT_NE(error("uint8_one_row.tif").find("has 3 columns and 1 row"), std::string::npos);
}
#endif

TEST(HgtGrid, TilesHaveTheirPlaceInTheirName) {
  Warnings warnings;
  // Three by three heights, from north to south; one of them is none.
  const std::string bytes{"\x00\x01\x00\x02\x00\x03\x01\x00\xff\xff\x80\x00\x00\x07\x00\x08\x00\x09", 18};
  const auto read = [&](const std::string& text, const std::string& name) {
    return read_grid(std::as_bytes(std::span(text)), name, warnings);
  };
  const auto tile = read(bytes, "tiles/S03W120.hgt");
  expect_grid(*tile, {-120, -119.5, -119}, {-3, -2.5, -2}, {{7, 8, 9}, {256, -1, kNaN}, {1, 2, 3}});
  EXPECT_EQ(tile->unit(), GroundUnit::degrees);
  EXPECT_EQ(error_line([&] { read(bytes, "alps.hgt"); }),
            "alps.hgt: has no position: the name of an SRTM tile gives it, such as N47E008.hgt");
  EXPECT_EQ(error_line([&] { read(bytes + "a", "N03E120.hgt"); }),
            "N03E120.hgt: has 19 bytes, which is not a square of two-byte heights");
}

TEST(SharedGrids, ModelsAreRefused) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  for (const char* model :
       {"CITY.ASC", "TESTI.ASC", "teapot.obj", "featuretype.stl", "octagonal_pocket.ply", "simple_pole.glb"}) {
    EXPECT_NE(error_line([&] { read_grid(folder / model, warnings); }).find("is a model ("), std::string::npos) << model;
  }
}

double value(const std::string& formula, double x, double y) {
  return heights_of(*formula_heights(formula, {x, x + 1}, {y, y + 1}))[0][0];
}

std::string error(const std::string& formula) {
  return error_line([&] { formula_heights(formula, {0, 1}, {0, 1}); });
}

TEST(FormulaHeights, RowsAreThoseOfY) {
  expect_grid(*formula_heights("10*x + y", {1, 2, 3}, {4, 5}), {1, 2, 3}, {4, 5}, {{14, 24, 34}, {15, 25, 35}});
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

TEST(FormulaHeights, HostileLengths) {
  EXPECT_EQ(error(std::string(1'000'000, '(')), "formula:10001: is longer than 10000 characters");
  EXPECT_EQ(error(std::string(10'000, '(')), "formula:10000: '(' without its ')'");
  std::string nested(4'000, '(');
  nested.append("x").append(4'000, ')');
  EXPECT_EQ(value(nested, 2, 3), 2);
  std::string sum = "x";
  while (sum.size() + 2 <= 10'000) sum += "+1";
  EXPECT_EQ(value(sum, 0, 0), 4999);
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

TEST(Formula, PrintedCharactersAndMoreFunctions) {
  expect_grid(*formula_heights("x² + y³ − 2·x", {1, 2, 3}, {1, 2}), {1, 2, 3}, {1, 2}, {{0, 1, 4}, {7, 8, 11}});
  expect_grid(*formula_heights("ln(e^x) + pow(y,2) + cbrt(8) + erf(0) + sec(0)", {1, 2}, {1, 2}), {1, 2}, {1, 2},
              {{5, 6}, {8, 9}});
}

}  // namespace
}  // namespace ligne
