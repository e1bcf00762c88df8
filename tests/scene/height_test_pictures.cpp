#include <algorithm>
#include <numbers>
#include <thread>

#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

TEST(PgmGrid, NorthIsUp) {
  const std::vector<std::vector<double>> z{{3, 4, 255}, {0, 1, 2}};
  expect_grid(*grid("P2 # note\n3 2\n# another\n255\n0 1 2\n3 4 255"), {0, 1, 2}, {0, 1}, z);
  expect_grid(*grid(corpus_file("binary_8.pgm")), {0, 1, 2}, {0, 1}, z);
}

TEST(PgmGrid, SixteenBitsHaveTheHighByteFirst) {
  expect_grid(*grid(corpus_file("binary_16.pgm")), {0, 1}, {0, 1}, {{0x04ff, 0xffff}, {1, 0x0203}});
  expect_grid(*grid("P2 2 2 65535 1 515 1279 65535\n"), {0, 1}, {0, 1}, {{0x04ff, 0xffff}, {1, 0x0203}});
}

TEST(PgmGrid, Errors) {
  EXPECT_EQ(grid_error("P5 2 2 255\n\x01\x02\x03"), "M: is truncated: 2 x 2 values do not fit into 3 bytes");
  EXPECT_EQ(grid_error("P2 2 2 255\n1 2\n3 \n#...\n"), "M:5: is truncated before the value");
  EXPECT_EQ(grid_error("P2 2 2 255\n1 2\n3 256\n"), "M:3: value 256 is not between 0 and 255");
  EXPECT_EQ(grid_error("P2 2 2 255\n1 2\nx 6\n"), "M:3: value 'x' is not a whole number");
  EXPECT_EQ(grid_error("P5 2 2 7\n\x01\x02\x03\x08"), "M: value 8 is above the largest of the header, 7");
  EXPECT_EQ(grid_error("P5 4294967296 4294967296 255\n"), "M:1: width 4294967296 is not between 1 and 29");
  EXPECT_EQ(grid_error("P5 2 2 65536\n1234"), "M:1: largest value 65536 is not between 1 and 65535");
  EXPECT_EQ(grid_error("P5 2"), "M:1: is truncated before the height");
  EXPECT_EQ(grid_error("P2 1 2 255 1 2"), "M: has 1 column and 2 rows; a grid has two of each or more");
  EXPECT_EQ(grid_error("P6 1 1 255 abc"), "M: is a Netpbm picture P6; heights need a grey one, P2 or P5");
}

TEST(PgmGrid, WhatFollowsIsLeftOut) {
  Warnings warnings;
  expect_grid(*grid("P5 2 2 255\nABCDP5 2 2 255\nABCD", warnings), {0, 1}, {0, 1}, {{67, 68}, {65, 66}});
  EXPECT_EQ(warnings.counts().size(), 1u);
}

TEST(PngGrid, DepthsAndInterlacing) {
  expect_grid(*grid(corpus_file("grey_8.png")), {0, 1, 2}, {0, 1}, {{4, 5, 255}, {1, 2, 3}});
  expect_grid(*grid(corpus_file("grey_16.png")), {0, 1}, {0, 1}, {{65535, 3}, {1, 256}});
  expect_grid(*grid(corpus_file("grey_16_interlaced.png")), {0, 1}, {0, 1}, {{65535, 3}, {1, 256}});
  expect_grid(*grid(corpus_file("grey_1.png")), {0, 1}, {0, 1}, {{1, 0}, {0, 1}});
}

TEST(PngGrid, TransparentIsAHole) {
  expect_grid(*grid(corpus_file("grey_transparent.png")), {0, 1}, {0, 1}, {{kNaN, 4}, {1, 2}});
}

TEST(PngGrid, TerrariumColoursAreHeights) {
  Warnings warnings;
  const auto source = grid(corpus_file("terrarium.png"), warnings);
  EXPECT_EQ(heights_of(*source), (std::vector<std::vector<double>>{{2500, 8848, -10000}, {0, 10.5, -3.25}}));
  ASSERT_EQ(warnings.counts().size(), 1u) << "that colours are taken for heights is said";
}

TEST(PngGrid, Errors) {
  EXPECT_EQ(grid_error(corpus_file("colours.png")),
            "M: is a PNG picture of colours; heights need one grey channel of 8 or 16 bits, or the Terrarium encoding");
  EXPECT_EQ(grid_error(corpus_file("truncated.png")), "M: is a broken PNG picture: the file ends early");
  EXPECT_EQ(grid_error(corpus_file("rows_missing.png")).substr(0, 27), "M: is a broken PNG picture:");
  EXPECT_EQ(grid_error(corpus_file("header_lies.png")).substr(0, 67),
            "M: is a broken PNG picture: 900000 x 900000 values do not fit into ");
  EXPECT_EQ(grid_error("\x89PNG"), "M: is a broken PNG picture: the file ends early");
}

TEST(GridFile, WithoutAFile) {
  Warnings warnings;
  EXPECT_EQ(error_line([&] { read_grid(std::filesystem::path("absent.csv"), warnings); }),
            "absent.csv: there is no such file");
}

TEST(SharedGrids, Volcano) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  const auto matrix = read_grid(folder / "volcano.csv", warnings), points = read_grid(folder / "volcano.dat", warnings);
  EXPECT_EQ(matrix->x().size(), 61u);
  EXPECT_EQ(matrix->y().size(), 87u);
  EXPECT_EQ(points->x().size(), 87u);
  EXPECT_EQ(points->x().back(), 860);
  EXPECT_EQ(points->y().back(), 600);
  EXPECT_TRUE(warnings.counts().empty());
  const auto a = heights_of(*matrix), b = heights_of(*points);
  double low = a[0][0], high = low;
  for (std::size_t j = 0; j < a.size(); ++j) {
    for (std::size_t i = 0; i < a[j].size(); ++i) {
      EXPECT_EQ(a[j][i], b[i][j]);
      low = std::min(low, a[j][i]);
      high = std::max(high, a[j][i]);
    }
  }
  EXPECT_EQ(low, 94);
  EXPECT_EQ(high, 195);
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

TEST(SharedGrids, Gully) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  const auto source = read_grid(folder / "west_bijou_gully.asc", warnings);
  EXPECT_EQ(source->x().size(), 43u);
  EXPECT_EQ(source->y().size(), 89u);
  EXPECT_EQ(source->x().front(), 559706.5);
  EXPECT_EQ(source->y().front(), 4380221.5);
  const Summary summary = summary_of(*source);
  EXPECT_NEAR(summary.low, 1680.8, 0.05);
  EXPECT_NEAR(summary.high, 1725.4, 0.05);
  EXPECT_GT(summary.holes, 0u);
}

TEST(SharedGrids, Jacksboro) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  const auto source = read_grid(folder / "jacksboro_dem_16bit.png", warnings);
  EXPECT_EQ(source->x().size(), 403u);
  EXPECT_EQ(source->y().size(), 344u);
  const Summary summary = summary_of(*source);
  EXPECT_EQ(summary.low, 236);
  EXPECT_EQ(summary.high, 1076);
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

TEST(FormulaHeights, OperatorsBindAsInMathematics) {
  EXPECT_EQ(value("-x^2", 2, 3), -4);
  EXPECT_EQ(value("2^3^2", 0, 0), 512);
  EXPECT_EQ(value("2^-1", 0, 0), 0.5);
  EXPECT_EQ(value("x ** 2 + y**3", 2, 3), 31);
  EXPECT_EQ(value("x - y - 1", 2, 3), -2);
  EXPECT_EQ(value("x/y/2", 6, 3), 1);
  EXPECT_EQ(value("1 + 2*3", 0, 0), 7);
  EXPECT_EQ(value("(1 + 2)*3", 0, 0), 9);
  EXPECT_EQ(value("x--y", 2, 3), 5);
  EXPECT_EQ(value("2*-x", 2, 3), -4);
  EXPECT_EQ(value(".5e1 + 1.", 0, 0), 6);
}

TEST(FormulaHeights, ComparisonsAndChoices) {
  EXPECT_EQ(value("x <= 2 && y > 3 || x == 2", 2, 3), 1);
  EXPECT_EQ(value("x != 2", 2, 3), 0);
  EXPECT_EQ(value("x < y ? 1 : 2", 2, 3), 1);
  EXPECT_EQ(value("x >= y ? 1 : x == 2 ? 5 : 6", 2, 3), 5);
  EXPECT_EQ(value("if(x > y, 1, if(x == 2, 7, 8))", 2, 3), 7);
  EXPECT_TRUE(std::isnan(value("if(sqrt(-x), 1, 2)", 2, 3)));
}

TEST(FormulaHeights, VariablesAndConstants) {
  EXPECT_EQ(value("r", 3, 4), 5);
  EXPECT_EQ(value("theta", -1, 0), std::numbers::pi);
  EXPECT_EQ(value("theta", 0, -2), -std::numbers::pi / 2);
  EXPECT_EQ(value("pi", 0, 0), std::numbers::pi);
  EXPECT_EQ(value("e", 0, 0), std::numbers::e);
  EXPECT_EQ(value("sin ( x )", 1, 0), std::sin(1.0));
}

TEST(FormulaHeights, Functions) {
  const double x = 0.3, y = -0.7;
  const std::vector<std::pair<std::string, double>> cases{{"sin(x)", std::sin(x)},
                                                          {"cos(x)", std::cos(x)},
                                                          {"tan(x)", std::tan(x)},
                                                          {"asin(x)", std::asin(x)},
                                                          {"acos(x)", std::acos(x)},
                                                          {"atan(x)", std::atan(x)},
                                                          {"atan2(y, x)", std::atan2(y, x)},
                                                          {"sinh(x)", std::sinh(x)},
                                                          {"cosh(x)", std::cosh(x)},
                                                          {"tanh(x)", std::tanh(x)},
                                                          {"sqrt(x)", std::sqrt(x)},
                                                          {"exp(x)", std::exp(x)},
                                                          {"log(x)", std::log(x)},
                                                          {"log10(x)", std::log10(x)},
                                                          {"log2(x)", std::log2(x)},
                                                          {"abs(y)", 0.7},
                                                          {"min(x, y, 3)", y},
                                                          {"max(x, y, -3)", x},
                                                          {"min(x)", x},
                                                          {"floor(y)", -1},
                                                          {"ceil(y)", 0},
                                                          {"round(y)", -1},
                                                          {"round(-2.5)", -3},
                                                          {"sign(y)", -1},
                                                          {"sign(0)", 0},
                                                          {"mod(5, 3)", 2},
                                                          {"mod(-1, 3)", 2},
                                                          {"mod(1, -3)", -2},
                                                          {"mod(-3, 3)", 0},
                                                          {"hypot(3, 4)", 5}};
  for (const auto& [formula, expected] : cases) EXPECT_DOUBLE_EQ(value(formula, x, y), expected) << formula;
}

TEST(FormulaHeights, WhatIsNoFiniteNumberIsAHole) {
  for (const char* formula :
       {"1/x", "x/x", "log(x)", "sqrt(-1)", "asin(2)", "exp(1000)", "mod(1, x)", "min(1, 0/x)", "max(0/x, 1)"}) {
    EXPECT_TRUE(std::isnan(value(formula, 0, 0))) << formula;
  }
  EXPECT_DOUBLE_EQ(value("atan(1/x)", 0, 0), std::numbers::pi / 2) << "infinite on the way, finite in the end";
}

TEST(FormulaHeights, ErrorsNameTheColumn) {
  EXPECT_EQ(error(""), "formula:1: is empty");
  EXPECT_EQ(error(" \t"), "formula:1: is empty");
  EXPECT_EQ(error("x + foo"), "formula:5: unknown name 'foo'; there are x, y, r, theta, pi and e");
  EXPECT_EQ(error("x + foo (x)").find("formula:5: unknown function 'foo'; there are sin cos tan "), 0u);
  EXPECT_NE(error("foo(x)").find(" erf "), std::string::npos);
  EXPECT_EQ(error("X"), "formula:1: unknown name 'X'; there are x, y, r, theta, pi and e");
  EXPECT_EQ(error("1 + sin"), "formula:5: function 'sin' without its arguments in parentheses");
  EXPECT_EQ(error("2x"), "formula:2: an operator is missing before 'x'");
  EXPECT_EQ(error("x (y)"), "formula:3: an operator is missing before '('");
  EXPECT_EQ(error("x = 3"), "formula:3: assignment is not allowed; use == to compare");
  EXPECT_EQ(error("x + \"abc\""), "formula:5: character '\"' is not allowed in a formula");
  EXPECT_EQ(error("x\u20ac"), "formula:2: character '\xE2\x82\xAC' is not allowed in a formula");
  EXPECT_EQ(error("1e999"), "formula:1: '1e999' is out of the range of numbers");
  EXPECT_EQ(error("x + ."), "formula:5: '.' is not a number");
  EXPECT_EQ(error("(x + (y)"), "formula:1: '(' without its ')'");
  EXPECT_EQ(error("x + y)"), "formula:6: ')' without its '('");
  EXPECT_EQ(error("x, y"), "formula:2: ',' outside the arguments of a function");
  EXPECT_EQ(error("(x, y)"), "formula:7: several values in parentheses without a function");
  EXPECT_EQ(error("x + "), "formula:5: ends too early");
  EXPECT_EQ(error("x  */ y"), "formula:5: '/' is not expected here");
  EXPECT_EQ(error("()"), "formula:2: ')' is not expected here");
  EXPECT_EQ(error("hypot(1)"), "formula:8: too few arguments for 'hypot'");
  EXPECT_EQ(error("sin(1, 2)"), "formula:9: too many arguments for 'sin'");
  EXPECT_EQ(error("x ? y"), "formula:6: '?' without its ':'");
  EXPECT_EQ(error("x : y"), "formula:5: ':' without its '?'");
  EXPECT_EQ(error("(x ? y) : 1"), "formula:12: its parts do not fit together");
  EXPECT_EQ(error(std::string("x\0y", 3)), "formula:2: character '\\x00' is not allowed in a formula");
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
  EXPECT_EQ(error("x²y").substr(0, 40), "formula:4: an operator is missing before");
  EXPECT_EQ(error("²"), "formula:1: '^' is not expected here");
}

}  // namespace
}  // namespace ligne
