#include <thread>

#include "height_tools.hpp"

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

}  // namespace
}  // namespace ligne
