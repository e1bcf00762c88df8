#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

const std::vector<std::vector<double>> kTwoByTwo{{1, 2}, {3, 4}};

TEST(TextGrid, RowsCountUpFromYZero) { expect_grid(*grid("1,2,3\n4,5,6.5\n"), {0, 1, 2}, {0, 1}, {{1, 2, 3}, {4, 5, 6.5}}); }

TEST(TextGrid, Separators) {
  for (const char* text : {"1,2\n3,4\n", "1, 2\r\n3 ,4", "1;2\r3;4\r", "1\t2\n3\t4\n", "  1  2 \n\t3\t 4\n",
                           "\xEF\xBB\xBF"
                           "1,2\n3,4\n",
                           "# heights\n\n1 2 # first\n#\n3 4\n\n\n"}) {
    SCOPED_TRACE(text);
    expect_grid(*grid(text), {0, 1}, {0, 1}, kTwoByTwo);
  }
  expect_grid(*grid("1,5;2\n-3,25e1;+4\n"), {0, 1}, {0, 1}, {{1.5, 2}, {-32.5, 4}});
}

TEST(TextGrid, Holes) {
  expect_grid(*grid("1,,3\nnan,-NaN,NA\n?,inf,7\n"), {0, 1, 2}, {0, 1, 2},
              {{1, kNaN, 3}, {kNaN, kNaN, kNaN}, {kNaN, kNaN, 7}});
  expect_grid(*grid("\t1\t2\n3\t\t\n"), {0, 1, 2}, {0, 1}, {{kNaN, 1, 2}, {3, kNaN, kNaN}});
}

TEST(TextGrid, NumbersThatStandForNoHeight) {
  for (const std::string sign : {"-9999", "-32768", "-99999.0"}) {
    Warnings warnings;
    const auto source = grid("1,2,3,4\n4," + sign + ",6,-50\n7,8,9,1\n", warnings);
    EXPECT_TRUE(std::isnan(heights_of(*source)[1][1])) << sign;
    EXPECT_EQ(warnings.counts().size(), 1u);
    Warnings of_table;
    const auto table = grid("x,y,z\n0,0,1\n1,0,2\n0,1," + sign + "\n1,1,4\n", of_table);
    EXPECT_TRUE(std::isnan(heights_of(*table)[1][0])) << sign;
  }
  // Depths of a sea, and numbers of another thing.
  EXPECT_EQ(heights_of(*grid("-2000,-5000,-7000\n-9999,-9998,-9000\n"))[1][0], -9999);
  EXPECT_EQ(heights_of(*grid("-9999,-9999\n-9999,-9999\n"))[1][0], -9999);
}

TEST(TextGrid, SeparatorAtTheEndOfEveryRow) {
  expect_grid(*grid("1,2,\n3,4,\n"), {0, 1}, {0, 1}, kTwoByTwo);
  expect_grid(*grid("1,2,\n3,4,5\n"), {0, 1, 2}, {0, 1}, {{1, 2, kNaN}, {3, 4, 5}});
}

TEST(TextGrid, NamesInQuotesAreLeftOut) {
  Warnings warnings;
  expect_grid(*grid("\"\",\"V1\",\"V,2\"\n\"1\",1,2\n\"2\",3,4\n", warnings), {0, 1}, {0, 1}, kTwoByTwo);
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 column (1), 1 head row");
  Warnings more;
  expect_grid(*grid("\"V1\" \"V 2\"\n\"a\" 1 2\n\"b\" 3 4\n", more), {0, 1}, {0, 1}, kTwoByTwo);
}

TEST(TextGrid, Errors) {
  EXPECT_EQ(grid_error(""), "M: is empty");
  EXPECT_EQ(grid_error("\n# nothing\n"), "M: holds no row of numbers");
  EXPECT_EQ(grid_error("1,2,3\n4,5\n"), "M:2: row of 2 columns; those above have 3");
  EXPECT_EQ(grid_error("1 2\n3 4\n5 6 7\n"), "M:3: row of 3 columns; those above have 2");
  EXPECT_EQ(grid_error("1,2\n3,abc\n"), "M:2: column 2: 'abc' is not a number");
  EXPECT_EQ(grid_error("a,b\n1,2\n"),
            "M:2: the columns a, b have unknown names; --using X:Y:Z says which columns are the positions and the height, "
            "--layout matrix that all are heights, --layout series that all but the first are");
  EXPECT_EQ(grid_error("1\n2\n3\n"), "M: has 1 column and 3 rows; a grid has two of each or more");
  EXPECT_EQ(grid_error("1,2,4\n"), "M: has 3 columns and 1 row; a grid has two of each or more");
  EXPECT_EQ(grid_error("nan,nan\nnan,nan\n"), "M: contains only NODATA values");
  EXPECT_EQ(grid_error("1,2\n3,1e999\n"), "M:2: column 2: '1e999' is not a number");
  EXPECT_EQ(
      grid_error(std::string("1,2\n3,\0\n", 8)),
      "M: is not a known grid format (text tables, ESRI ASCII grid, PGM, PNG, GeoTIFF, Surfer, npy, netCDF, MATLAB, JSON)");
  EXPECT_EQ(grid_error("1,2\n3,\x01\x80\n"), "M:2: column 2: '\\x01\\x80' is not a number");
  EXPECT_EQ(grid_error("\xFF\xFE"
                       "1"),
            "M: is UTF-16 text; UTF-8 is needed");
  EXPECT_EQ(
      grid_error("1 2 3 4\n5 6 7 8\n\n1 2 3 4\n"),
      "M:4: blank lines before this row of a matrix of 4 columns; blocks of x y z have three; --using X:Y:Z says which "
      "columns are the positions and the height, --layout matrix that all are heights, --layout series that all but the "
      "first are");
  EXPECT_EQ(grid_error("v 1 2 3\nv 2 3 4\n"), "M: is a model (OBJ), not a grid of heights; draw it with: ligne draw");
}

TEST(PointGrid, BlocksOfOneXOrOneY) {
  const std::vector<std::vector<double>> z{{1, 3}, {2, 4}, {kNaN, 5}};
  expect_grid(*grid("# x y z\n0 10 1\n0 20 2\n0 30 nan\n\n5 10 3\n5 20 4\n5 30 5\n\n"), {0, 5}, {10, 20, 30}, z);
  expect_grid(*grid("0,10,1\n5,10,3\n\n0,20,2\n5,20,4\n\n\n0,30,\n5,30,5\n"), {0, 5}, {10, 20, 30}, z);
  expect_grid(*grid("5 30 5\n5 20 4\n5 10 3\n\n0 30 nan\n0 20 2\n0 10 1\n"), {0, 5}, {10, 20, 30}, z);
}

TEST(PointGrid, WithoutBlankLinesWhenTheyFormAGrid) {
  expect_grid(*grid("0 0 1\n1 0 2\n0 1 3\n1 1 4\n"), {0, 1}, {0, 1}, kTwoByTwo);
  expect_grid(*grid("0 0 1\n0 1 3\n1 0 2\n1 1 4\n"), {0, 1}, {0, 1}, kTwoByTwo);
}

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
  expect_grid(*grid("0 0 1\n1 0 2\n0 1 3\n1 1 5\n1 1 3\n", warnings), {0, 1}, {0, 1}, kTwoByTwo);
  EXPECT_EQ(warnings.counts(), (std::map<std::string, std::size_t>{{"points at equal positions: heights averaged", 1}}));
}

TEST(PointGrid, TablesWithNamedColumns) {
  Warnings warnings;
  // As pandas writes a frame, with and without its index, and in other orders of rows and columns.
  for (const char* text : {",x,y,z\n0,0,0,1\n1,1,0,2\n2,0,1,3\n3,1,1,4\n", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n",
                           "name;Elevation;lat;lon\na;4;1;1\nb;1;0;0\nc;2;0;1\nd;3;1;0\n",
                           "\"x\" \"y\" \"temperature\"\n1 1 4\n0 0 1\n1 0 2\n0 1 3\n"}) {
    SCOPED_TRACE(text);
    expect_grid(*grid(text, warnings), {0, 1}, {0, 1}, kTwoByTwo);
  }
  EXPECT_EQ(grid_error("x,y,z\n0,0,1\n1,0\n"), "M:3: row of 2 columns; the header names 3");
  Warnings of_hole;
  EXPECT_EQ(grid("x,y,z\n0,0,1\n1,,5\n1,0,3\n0,1,4\n1,1,6\n", of_hole)->x(), (std::vector<double>{0, 1}));
  EXPECT_EQ(of_hole.left_out().text(), "left out: 1 rows without x or y");
  EXPECT_EQ(grid_error("x,y,z\n0,0,1\n1,1,2\n2,2,3\n"), "M: has only collinear points, which make no surface");
}

TEST(PointGrid, FramesOfPositions) {
  Warnings warnings;
  const std::vector<std::vector<double>> z{{1, 2}, {3, 4}};
  expect_grid(*grid(",0,1\n0,1,2\n1,3,4\n", warnings), {0, 1}, {0, 1}, z);
  expect_grid(*grid("lat,10.5,11.5\n7,3,4\n6,1,2\n", warnings), {10.5, 11.5}, {6, 7}, z);
  expect_grid(*grid(",a,b\n0,1,2\n1,3,4\n", warnings), {0, 1}, {0, 1}, z);
  EXPECT_EQ(warnings.counts().at("rows and columns of numbers read as positions"), 4u);
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

TEST(PointGrid, RoundingOfPositionsIsNoMistake) {
  const auto source = grid("0 0.1 1\n0 0.2 2\n\n1 0.10000000001 3\n1 0.2 4\n");
  EXPECT_EQ(source->y(), (std::vector<double>{0.1, 0.2}));
}

TEST(PointGrid, Errors) {
  EXPECT_EQ(grid_error("0 0 1\n\n0 1 2\n"),
            "M:1: block of a single point; the points of a grid come in blocks of one x or one y each");
  EXPECT_EQ(grid_error("0 0 nan\n0 1 nan\n\n1 0 nan\n1 1 nan\n"), "M: contains only NODATA values");
}

const std::string kCorner = "xllcorner 10\nyllcorner 20\ncellsize 2\n";

TEST(EsriGrid, NorthIsUpAndPositionsAreTheMiddlesOfCells) {
  const std::vector<std::vector<double>> z{{5, 6}, {kNaN, 4}, {1, 2}};
  expect_grid(*grid("ncols 2\nnrows 3\n" + kCorner + "NODATA_value -1\n1 2\n-1 4\n5 6\n"), {11, 13}, {21, 23, 25}, z);
  expect_grid(
      *grid("nodata_VALUE -1\r\nDY 3\r\nDX 2\r\nYLLCENTER 20\r\nxllcenter 10\r\nNROWS 3\r\nNcols 2\r\n1 2 -1 4\r\n5\r\n6"),
      {10, 12}, {20, 23, 26}, z);
  expect_grid(*grid("ncols 2\nnrows 3\n" + kCorner + "\n1 2\n-9999 4\n5 6\n"), {11, 13}, {21, 23, 25}, z);
}

TEST(EsriGrid, Errors) {
  const std::string head = "ncols 2\nnrows 2\n" + kCorner;
  EXPECT_EQ(grid_error(head + "1 2\n3\n"), "M:7: ends after 3 of 4 heights; line 7 has 1, ncols is 2");
  EXPECT_EQ(grid_error(head + "1 2\n3 4\n5\n"), "M:8: more heights than the 4 of the header");
  EXPECT_EQ(grid_error(head + "1 2\n3 x\n"), "M:7: 'x' is not a number");
  EXPECT_EQ(grid_error(head + "nonsense 7\n1 2\n3 4\n"), "M:6: unknown key 'nonsense' in the header");
  EXPECT_EQ(grid_error(head + "NODATA_value\n1 2\n3 4\n"), "M:6: key 'NODATA_value' needs one value");
  EXPECT_EQ(grid_error(head + "-9999 -9999 -9999 -9999"), "M: contains only NODATA values");
  EXPECT_EQ(grid_error("ncols 4294967296\nnrows 2\n"), "M:1: ncols '4294967296' is more than a file of 25 bytes can hold");
  EXPECT_EQ(grid_error("ncols 20\nnrows 20\n" + kCorner + "1 2\n"),
            "M: header declares 400 heights, more than a file of 59 bytes can hold");
  EXPECT_EQ(grid_error("ncols -3\n"), "M:1: ncols '-3' is not a number of cells");
  EXPECT_EQ(grid_error("ncols 2\nncols 2\n1 2\n"), "M: the header of the ESRI ASCII grid lacks nrows");
  EXPECT_EQ(grid_error("ncols 2\nnrows 2\ncellsize 1\nxllcorner 1\n1 2 3 4\n"),
            "M: the header of the ESRI ASCII grid lacks yllcorner");
  EXPECT_EQ(grid_error("ncols 1\nnrows 2\n" + kCorner + "1\n2\n"),
            "M: has 1 column and 2 rows; a grid has two of each or more");
  EXPECT_EQ(grid_error("cellsize 0\n"), "M:1: cellsize '0' is not above zero");
  EXPECT_EQ(grid_error("ncols 2\nnrows 2\nxllcorner 1e20\nyllcorner 0\ncellsize 1\n1 2 3 4\n"),
            "M: positions x do not ascend: number 2 is not above the one before it");
}

TEST(EsriGrid, A3DStudioFileOfTheSameSuffixIsAModel) {
  EXPECT_EQ(grid_error("Ambient light color: Red=0.3 Green=0.3 Blue=0.3\n\nNamed object: \"Box\"\n"),
            "M: is a model (3D Studio ASCII), not a grid of heights; draw it with: ligne draw");
}

}  // namespace
}  // namespace ligne
