/// What `ligne surface` makes of bad input: one line, the exit status and no file, or a right drawing of what there is.

#include <chrono>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class SurfaceInputTest : public SurfaceProgramTest {
 protected:
  /// By the horizon and by a mesh: the line, and no file beside those of the test.
  void refuses(const std::vector<std::string>& source, int status, const std::string& message) const {
    const std::vector<std::string> files = new_files();
    for (const std::vector<std::string>& method :
         {std::vector<std::string>{}, {"--method", "appel"}, {"--skirt"}, {"--contours", "5", "--axes"}}) {
      std::vector<std::string> arguments = source;
      arguments.insert(arguments.end(), method.begin(), method.end());
      arguments.insert(arguments.end(), {"-o", "out.svg"});
      fails(arguments, status, message);
      EXPECT_EQ(new_files(), files) << message;
    }
  }
  /// Length of a layer as seen from above, by a mesh method.
  double from_above(const std::string& formula, const std::string& layer, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{formula,  "-x",  "-2:2:5",    "-y", "-2:2:5",   "--samples", "5",
                                       "--view", "top", "--z-scale", "1",  "--method", "appel"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return length(drawn(arguments), layer);
  }
};

TEST_F(SurfaceInputTest, FormulasThatHaveNoValueInPlaces) {
  // Cut at 1 and -1: two strips 1 wide are left, of two curves with 5 curves across.
  EXPECT_NEAR(from_above("1/x", "horizon", {"--z-range", "-1:1"}), 2 * (2 * 4 + 5 * 1), kMicrometre);
  EXPECT_NEAR(from_above("1/x", "border", {"--z-range", "-1:1"}), 0, kMicrometre) << "all rims are curves";
  EXPECT_NEAR(from_above("1/x", "border", {"--lines", "x", "--z-range", "-1:1"}), 4, kMicrometre) << "the rims across";
  EXPECT_NEAR(from_above("sqrt(x)", "horizon"), 3 * 4 + 5 * 2, kMicrometre) << "x from 0 to 2";
  EXPECT_NEAR(from_above("log(x)", "horizon", {"--z-range", "0:1"}), 2 * 4 + 5 * 1, kMicrometre) << "x from 1 to 2";
}

TEST_F(SurfaceInputTest, TheHorizonLeavesOutWholeCells) {
  for (const char* formula : {"sqrt(x-0.1)", "asin(r/2.1)", "if(x < 0.1, sqrt(-1), y)", "floor(x+y)+x"}) {
    const std::vector<std::string> plot{formula, "-x",     "-2:2:17", "-y",      "-2:2:17", "--samples",
                                        "17",    "--view", "top",     "--scale", "10:1"};
    std::vector<std::string> horizon = plot;
    horizon.insert(horizon.end(), {"--method", "horizon"});
    const double seen = layers(horizon).at("horizon"), mesh = layers(plot).at("horizon");
    EXPECT_GT(seen, 10) << formula;
    EXPECT_LT(seen, mesh) << formula;
    EXPECT_GT(seen, 0.5 * mesh) << formula;
  }
}

TEST_F(SurfaceInputTest, FormulasWithoutAnyValue) {
  for (const char* formula : {"log(-1-r)", "0/0", "x/0", "1e308*10*x"}) {
    for (const char* more :
         {"--skirt", "--contours=3", "--axes", "--contours-base", "--ridgeline", "--lines=x", "--hidden=dashed"}) {
      fails({formula, more, "-o", "out.svg"}, 1, std::string("surface: ") + formula + " is nowhere a number");
    }
  }
  fails({"log(-1-r)", "x", "-o", "out.svg"}, 0, "surface: warning: log(-1-r) is nowhere a number");
}

TEST_F(SurfaceInputTest, Ranges) {
  refuses({"x", "-x", "1:1"}, 2, "-x: the range 1:1 does not ascend");
  refuses({"x", "-y", "2:-2"}, 2, "-y: the range 2:-2 does not ascend");
  refuses({"x", "-x", "0:1/0"}, 2, "-x: \"1/0\" is not a finite number");
  refuses({"x", "-x", "0:sqrt(-1)"}, 2, "-x: \"sqrt(-1)\" is not a finite number");
  refuses({"x", "-x", "-1.7e308:1.7e308"}, 2, "-x: the range -1.7e308:1.7e308 is too large");
  refuses({"x", "-x", ":"}, 2, "-x: ");
  refuses({"x", "-x", "1:2:3:4"}, 2, "-x: ");
  for (const char* n : {"0", "1", "-3", "2.5", "1000000000", "99999999999999999999"}) {
    refuses({"x", "-x", std::string("0:1:") + n}, 2, "-x: ");
    refuses({"x", "--samples", n}, 2, "--samples: ");
  }
  for (const char* n : {"0", "-1", "1.5", "1000000000"}) refuses({"x", "--contours", n}, 2, "--contours");
  for (const char* step : {"0", "-1", "nan", "inf"}) refuses({"x", "--contour-step", step}, 2, "--contour-step: ");
}

TEST_F(SurfaceInputTest, Grids) {
  const std::string esri_end = "xllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n";
  write("short.csv", "1,2,3\n4,5\n6,7,8\n");
  write("words.csv", "1,2\nx,4\n");
  write("prose.txt", "heights of hills\nwritten by hand\n");
  write("column.csv", "1\n2\n3\n");
  write("row.csv", "1,2,3\n");
  write("nan.txt", "nan nan\nnan nan\n");
  write("empty.csv", "");
  write("blank.csv", "\n\n\n");
  write("nodata.asc", "ncols 2\nnrows 2\n" + esri_end + "-9 -9\n-9 -9\n");
  write("wide.asc", "ncols 4294967296\nnrows 2\n" + esri_end + "1 2\n");
  write("tall.asc", "ncols 2\nnrows 4294967296\n" + esri_end + "1 2\n");
  write("both.asc", "ncols 4000000000\nnrows 4000000000\n" + esri_end + "1 2\n");
  write("early.asc", "ncols 2\nnrows 3\n" + esri_end + "1 2\n3 4\n5");
  write("big.pgm", "P5 4000000000 4000000000 255\n");
  write("noise.bin", std::string("\x01\x02\0\x03", 4));
  std::filesystem::create_directory(file("folder"));
  refuses({"--grid", "short.csv"}, 1, "short.csv:2: row of 2 columns; those above have 3\n");
  refuses({"--grid", "words.csv"}, 1, "words.csv:2: column 1: 'x' is not a number\n");
  refuses({"--grid", "prose.txt"}, 1, "prose.txt:1: column 1: 'heights' is not a number");
  refuses({"--grid", "column.csv"}, 1, "column.csv: has 1 column and 3 rows; a grid has two of each or more\n");
  refuses({"--grid", "row.csv"}, 1, "row.csv: has 3 columns and 1 row; a grid has two of each or more\n");
  refuses({"--grid", "nan.txt"}, 1, "nan.txt: holds no height, only places without one (NODATA)\n");
  refuses({"--grid", "nodata.asc"}, 1, "nodata.asc: holds no height, only places without one (NODATA)\n");
  refuses({"--grid", "empty.csv"}, 1, "empty.csv: is empty\n");
  refuses({"--grid", "blank.csv"}, 1, "blank.csv: holds no row of numbers\n");
  refuses({"--grid", "wide.asc"}, 1, "wide.asc:1: ncols '4294967296' is more than a file of ");
  refuses({"--grid", "tall.asc"}, 1, "tall.asc:2: nrows '4294967296' is more than a file of ");
  refuses({"--grid", "both.asc"}, 1, "both.asc:1: ncols '4000000000' is more than a file of ");
  refuses({"--grid", "early.asc"}, 1, "early.asc");
  refuses({"--grid", "big.pgm"}, 1, "big.pgm:1: width 4000000000 is not between 1 and ");
  refuses({"--grid", "noise.bin"}, 1, "noise.bin: not a grid file that is known");
  refuses({"--grid", "folder"}, 1, "folder: is a directory, not a file\n");
  refuses({"--grid", "nowhere.csv"}, 1, "nowhere.csv: ");
  refuses({"--grid", ""}, 1, "");
}

TEST_F(SurfaceInputTest, ContoursWithoutNumberOrMemory) {
  // Ten thousand levels on a steep sheet of two million triangles would cut it into thousands of millions.
  const auto begin = std::chrono::steady_clock::now();
  fails({"sin(50*x)*sin(50*y)", "-x", "0:1:500", "-y", "0:1:500", "--samples", "1000", "--contours", "10000", "--skirt",
         "-o", "out.svg"},
        1, "sin(50*x)*sin(50*y): has too many contour lines: they cut it into more than 12 million triangles\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_FALSE(exists("out.svg"));
}

}  // namespace
}  // namespace ligne::test
