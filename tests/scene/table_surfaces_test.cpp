// Tables of the kinds that people have, as surfaces.

#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

const std::vector<std::vector<double>> kMatrix{{1, 2, 3.5}, {4, 5, 6}};

std::vector<GridSurface> surfaces(const std::string& text, Warnings& warnings, const GridChoice& choice = {}) {
  return read_surfaces(reader_test::bytes_of(text), "M", warnings, {}, nullptr, choice);
}

std::string left_out_of(const std::string& text, const GridChoice& choice = {}) {
  Warnings warnings;
  surfaces(text, warnings, choice);
  return warnings.left_out().text();
}

TEST(TableSurface, WritersHabits) {
  for (const char* text : {"\"1\",\"2\",\"3.5\"\n\"4\",\"5\",\"6\"\n", "1.0D0 2.0D0 3.5D+00\n4 5 6\n",
                           "1\t2\t3,5\n4\t5\t6\n", "1|2|3.5\n4|5|6\n", "% MATLAB\n1 2 3.5\n4 5 6\n"}) {
    SCOPED_TRACE(text);
    expect_grid(*grid(text), {0, 1, 2}, {0, 1}, kMatrix);
  }
  for (const char* hole : {"null", "None", "NULL", "N/A", "#N/A", "NaN", "-", "*", "NA", ""}) {
    SCOPED_TRACE(hole);
    expect_grid(*grid("1,2,3\n4," + std::string(hole) + ",6\n"), {0, 1, 2}, {0, 1}, {{1, 2, 3}, {4, kNaN, 6}});
  }
}

TEST(TableSurface, NamesOfR) {
  Warnings warnings;
  expect_grid(*grid("V1,V2,V3\n1,2,3.5\n4,5,6\n", warnings), {0, 1, 2}, {0, 1}, kMatrix);
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 head row");
  Warnings more;
  expect_grid(*grid("rownames,V1,V2,V3\n1,1,2,3.5\n2,4,5,6\n", more), {0, 1, 2}, {0, 1}, kMatrix);
  EXPECT_EQ(more.left_out().text(), "left out: 1 column (rownames), 1 head row");
}

TEST(TableSurface, HeadsThatArePositions) {
  Warnings warnings;
  const std::vector<std::vector<double>> z{{1, 2, 3}, {4, 5, 6}};
  expect_grid(*grid("year,Jan,Feb,Mar\n1950,1,2,3\n1951,4,5,6\n", warnings), {1, 2, 3}, {1950, 1951}, z);
  expect_grid(*grid("depth,X10,X20,X30\n5,4,5,6\n2,1,2,3\n", warnings), {10, 20, 30}, {2, 5}, z);
  expect_grid(*grid("rownames,X1856,X1860,X1870\nOhio,1,2,3\nIowa,4,5,6\n", warnings), {1856, 1860, 1870}, {0, 1}, z);
  expect_grid(*grid("month,1950,1951,1952\nJan,1,2,3\nFeb,4,5,6\n", warnings), {1950, 1951, 1952}, {1, 2}, z);
}

/// Rows of a position from 20 downwards by halves, and of heights that are no line in any column.
std::string series_text(const std::string& head, double offset = 0, double apart = 1) {
  std::string text = head;
  for (int row = 0; row < 9; ++row) {
    text += std::to_string(20 - row * 0.5);
    for (int k = 0; k < 3; ++k) text += "," + std::to_string(offset + row * row * 0.25 + k * apart);
    text += "\n";
  }
  return text;
}

GridChoice with_layout(TableLayout layout) {
  GridChoice choice;
  choice.layout = layout;
  return choice;
}

void expect_series(const HeightSource& source) {
  ASSERT_EQ(source.x(), (std::vector<double>{0, 1, 2}));
  ASSERT_EQ(source.y(), (std::vector<double>{16, 16.5, 17, 17.5, 18, 18.5, 19, 19.5, 20}));
  EXPECT_EQ(heights_of(source)[0], (std::vector<double>{16, 17, 18})) << "the last row";
}

TEST(TableSurface, PositionsInTheFirstColumnBySteps) {
  for (const char* head : {"", "\"a\",\"b\",\"c\",\"d\"\n", "V1,V2,V3,V4\n"}) {
    SCOPED_TRACE(head);
    Warnings warnings;
    expect_series(*grid(series_text(head), warnings));
    ASSERT_EQ(warnings.counts().size(), 1u);
    EXPECT_NE(warnings.counts().begin()->first.find("read as positions; --layout matrix: heights"), std::string::npos);
  }
  Warnings warnings;
  EXPECT_EQ(surfaces(series_text(""), warnings, with_layout(TableLayout::matrix))[0].heights->x().size(), 4u);
}

TEST(TableSurface, PositionsInTheFirstColumnByNames) {
  for (const char* head : {"wavelength,s1,s2,s3\n", "Wavelength (nm),s1,s2,s3\n", ",s1,s2,s3\n", "Unnamed: 0,a,b,c\n",
                           "\"time\",\"a\",\"b\",\"c\"\n"}) {
    SCOPED_TRACE(head);
    Warnings warnings;
    expect_series(*grid(series_text(head), warnings));
  }
  EXPECT_NE(grid_error(series_text("time,a,b,c\n")).find("--layout series that all but the first are"), std::string::npos);
  // Positions need no even steps where their name says what they are.
  Warnings warnings;
  expect_grid(*grid("energy,s1,s2,s3\n1,5,2,9\n10,4,8,1\n100,0,3,2\n", warnings), {0, 1, 2}, {1, 10, 100},
              {{5, 2, 9}, {4, 8, 1}, {0, 3, 2}});
}

TEST(TableSurface, ADoubtfulFirstColumnIsHeightsWithAWarning) {
  // The first column is as near to the others as they are to each other.
  Warnings warnings;
  const std::string text = series_text("", 17, 3);
  EXPECT_EQ(surfaces(text, warnings)[0].heights->x().size(), 4u);
  EXPECT_EQ(warnings.lines(), std::vector<std::string>{"1 column (1) read as heights; --layout series: positions"});
  Warnings none;
  EXPECT_EQ(surfaces(text, none, with_layout(TableLayout::series))[0].heights->y().front(), 16);
  EXPECT_TRUE(none.lines().empty());
}

TEST(TableSurface, PlanesAndFewRowsAreHeightsWithoutAWarning) {
  std::string plane, few;
  for (int row = 0; row < 9; ++row) {
    const std::string line =
        std::to_string(row) + " " + std::to_string(100 + row) + " " + std::to_string(row * row) + " 4\n";
    plane += line;
    if (row < 7) few += line.substr(0, 2) + " 100 " + std::to_string(row * row % 5) + " 4\n";
  }
  EXPECT_EQ(grid(plane)->x().size(), 4u);
  EXPECT_EQ(grid(few)->x().size(), 4u);
  Warnings warnings;
  EXPECT_EQ(error_line([&] { surfaces("1 2 3\n3 4 5\n2 5 6\n", warnings, with_layout(TableLayout::series)); }),
            "M: has no positions in its first column: they neither ascend nor descend throughout");
}

TEST(TableSurface, AFirstRowBehindAWordHoldsNoHeights) {
  Warnings warnings;
  expect_grid(*grid("station,2000,2010,2020\nHof,1,2,3\nUlm,4,5,6\n", warnings), {2000, 2010, 2020}, {0, 1},
              {{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 column of row names");
}

TEST(TableSurface, BelowNamesTheFirstRowHoldsHeights) {
  Warnings warnings;
  const std::string rows = "Hof,5,2,3\nUlm,4,5,6\nTrier,7,8,9\n";
  expect_grid(*grid("rownames,V1,V2,V3\n" + rows, warnings), {0, 1, 2}, {0, 1, 2}, {{5, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 column (rownames), 1 head row");
  EXPECT_TRUE(
      grid_error("town,hotels,bridges,churches\n" + rows).starts_with("M:2: the columns hotels, bridges, churches "));
}

TEST(TableSurface, FactsAboutThingsAreNoMatrix) {
  for (const char* text : {",id,diet,pulse,time\n0,1,low fat,85,1 min\n1,1,low fat,88,9 min\n",
                           "\"a\",\"b\"\n3.6,79\n1.8,54\n", "\"a\",\"b\",\"c\",\"kind\"\n1,5,2,x\n2,4,9,y\n"}) {
    EXPECT_NE(grid_error(text).find("have unknown names"), std::string::npos) << text;
  }
}

TEST(TableSurface, LongTablesOfAnyNames) {
  Warnings warnings;
  expect_grid(*grid("time,freq,power\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n", warnings), {0, 1}, {0, 1}, {{1, 2}, {3, 4}});
  EXPECT_EQ(warnings.counts().begin()->first, "columns read as x, y and z: time, freq, power");
  EXPECT_EQ(left_out_of("id,lon,lat,value,station\n0,0,0,1,a\n1,1,0,2,b\n2,0,1,3,c\n3,1,1,4,d\n"),
            "left out: 2 columns (id, station)");
  EXPECT_EQ(grid_error("lon,lat,a,b\n0,0,1,2\n"),
            "M: has positions in columns lon and lat, and no height: --using NAME says which of a, b it is");
  EXPECT_EQ(
      grid_error("mpg,cyl,hp\n21,6,110\n22,6,110\n21,6,112\n22,6,112\n"),
      "M:2: the columns mpg, cyl, hp have unknown names; --using X:Y:Z says which columns are the positions and the height, "
      "--layout matrix that all are heights, --layout series that all but the first are");
}

TEST(TableSurface, FieldsOfRowsAndColumns) {
  Warnings warnings;
  expect_grid(*grid("rownames,row,col,yield\n1,1,1,1\n2,1,2,2\n3,2,1,3\n4,2,2,4\n", warnings), {1, 2}, {1, 2},
              {{1, 2}, {3, 4}});
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 column (rownames)");
}

TEST(TableSurface, RepeatedFieldsAreAveragedAndNoMesh) {
  Warnings warnings;
  const std::string once = "1,1,%\n1,2,%\n2,1,%\n2,2,%\n";
  std::string text = "row,col,yield\n";
  for (const char* yield : {"1", "3"}) {
    for (const char c : once) text += c == '%' ? yield : std::string(1, c);
  }
  expect_grid(*grid(text, warnings), {1, 2}, {1, 2}, {{2, 2}, {2, 2}});
  EXPECT_EQ(warnings.counts().at("points at equal positions: heights averaged"), 4u);
  Warnings more;
  expect_grid(*grid("row,col,yield\n1,1,1\n1,2,2\n2,1,NA\n2,2,4\n1,1,3\n1,2,NA\n2,1,5\n2,2,NA\n", more), {1, 2}, {1, 2},
              {{2, 2}, {5, 4}});
  EXPECT_EQ(grid_error("row,col,state\n1,1,Y\n1,2,N\n"),
            "M: has positions in columns col and row, and no column of heights; --points FILE marks them on a surface");
}

TEST(TableSurface, NonuniformMatrix) {
  Warnings warnings;
  expect_grid(*grid("3 0 0.5 2\n10 1 2 3\n20 4 5 6\n", warnings), {0, 0.5, 2}, {10, 20}, {{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(warnings.counts().size(), 1u);
  GridChoice matrix;
  matrix.layout = TableLayout::matrix;
  Warnings none;
  EXPECT_EQ(surfaces("3 0 0.5 2\n10 1 2 3\n20 4 5 6\n", none, matrix)[0].heights->x().size(), 4u);
  GridChoice frame;
  frame.layout = TableLayout::frame;
  expect_grid(*surfaces("7 0 0.5 2\n10 1 2 3\n20 4 5 6\n", none, frame)[0].heights, {0, 0.5, 2}, {10, 20},
              {{1, 2, 3}, {4, 5, 6}});
}

TEST(TableSurface, BlocksOfFourColumns) {
  const std::string text = "0 0 1 7\n1 0 2 7\n\n0 1 3 7\n1 1 4 7\n";
  EXPECT_EQ(left_out_of(text), "left out: 1 column (4)");
  Warnings warnings;
  expect_grid(*grid(text, warnings), {0, 1}, {0, 1}, {{1, 2}, {3, 4}});
  GridChoice choice;
  choice.using_columns = {"1", "2", "4"};
  const auto chosen = surfaces("0 0 1 7\n1 0 2 8\n\n0 1 3 9\n1 1 4 10\n", warnings, choice);
  expect_grid(*chosen[0].heights, {0, 1}, {0, 1}, {{7, 8}, {9, 10}});
}

TEST(TableSurface, MeshesOfBlocks) {
  Warnings warnings;
  const auto found = surfaces("0 0 0\n1 0.1 1\n2 0.2 4\n\n0 1 0\n1 1.1 nan\n2 1.2 4\n", warnings);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_TRUE(found[0].mesh);
  const SurfacePoints& mesh = *found[0].mesh;
  EXPECT_EQ(mesh.columns, 3u);
  EXPECT_EQ(mesh.rows, 2u);
  EXPECT_TRUE(mesh.parametric);
  EXPECT_EQ(mesh.points[5], (Point3{2, 1.2, 4}));
  EXPECT_TRUE(std::isnan(mesh.points[4].x)) << "a hole in all coordinates";
  EXPECT_EQ(warnings.lines(), (std::vector<std::string>{"2 rows of a mesh whose x and y both vary"}));
}

TEST(TableSurface, PolygonsOfASolidAreNoMesh) {
  // A tetrahedron.
  const char* corners[] = {"0 0 0\n", "1 0 0\n", "0 1 0\n", "0 0 1\n"};
  std::string text;
  for (int left_out = 0; left_out < 4; ++left_out) {
    for (int k = 0; k < 4; ++k) text += k == left_out ? "" : corners[k];
    text += "\n";
  }
  EXPECT_EQ(
      grid_error(text),
      "M: has blocks that are the polygons of a solid, not scan lines of a surface: write them as OFF or OBJ, and draw "
      "them with: ligne draw");
}

TEST(TableSurface, DataSetsAndTheirNumbers) {
  const std::string text = "0 0 1\n1 0 2\n\n0 1 3\n1 1 4\n\n\n5 5 1\n6 5 2\n\n5 6 3\n6 6 4\n";
  Warnings warnings;
  const auto all = surfaces(text, warnings);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].heights->x(), (std::vector<double>{5, 6}));
  GridChoice second;
  second.data_set = 1;
  EXPECT_EQ(surfaces(text, warnings, second)[0].heights->y(), (std::vector<double>{5, 6}));
  second.data_set = 2;
  EXPECT_EQ(error_line([&] { surfaces(text, warnings, second); }),
            "M: has 2 data sets, numbered from 0, and none of number 2");
}

TEST(TableSurface, UnevenBlocksAreAGridWithHoles) {
  Warnings warnings;
  expect_grid(*grid("0 0 1\n1 0 2\n2 0 3\n\n0 1 4\n1 1 5\n", warnings), {0, 1, 2}, {0, 1}, {{1, 2, 3}, {4, 5, kNaN}});
  EXPECT_EQ(warnings.lines(), (std::vector<std::string>{"2 blocks of different lengths: places without a point are holes"}));
}

TEST(TableSurface, SegmentsOfGmtAreBlocks) {
  expect_grid(*grid("> a\n0 0 1\n1 0 2\n> b\n0 1 3\n1 1 4\n"), {0, 1}, {0, 1}, {{1, 2}, {3, 4}});
}

TEST(TableSurface, HeightsThatNoGroundHas) {
  Warnings warnings;
  expect_grid(*grid("1,2,3\n4,1.70141e+38,6\n", warnings), {0, 1, 2}, {0, 1}, {{1, 2, 3}, {4, kNaN, 6}});
  EXPECT_EQ(warnings.counts().begin()->first, "heights beyond 1e30 read as NODATA");
}

TEST(TableSurface, OneTerrainInThirteenHabits) {
  // All files hold these 16 x 12 heights; two are missing in some.
  const auto plain = heights_of(*grid(corpus_file("csv_quoted.csv")));
  ASSERT_EQ(plain.size(), 12u);
  for (const char* file :
       {"fortran_d.txt", "gp_blocks4.dat", "gp_nonuniform.dat", "json_nested.json", "miss_null.csv", "r_unquoted_header.csv",
        "surfer_dsaa.grd", "tsv_comma.tsv", "xyz_xtz.csv", "z.npy", "csv_quoted.csv.gz"}) {
    SCOPED_TRACE(file);
    Warnings warnings;
    const auto found = heights_of(*grid(corpus_file(file), warnings));
    ASSERT_EQ(found.size(), plain.size());
    std::size_t holes = 0;
    for (std::size_t j = 0; j < plain.size(); ++j) {
      ASSERT_EQ(found[j].size(), plain[j].size());
      for (std::size_t i = 0; i < plain[j].size(); ++i) {
        holes += std::isnan(found[j][i]);
        const double height = std::isnan(found[j][i]) ? plain[j][i] : found[j][i];
        EXPECT_NEAR(height, plain[j][i], 1e-6);
      }
    }
    EXPECT_LE(holes, 12u);
  }
}

TEST(TableSurface, EsriNoDataOfFewerDigits) {
  const std::string head = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value ";
  for (const char* data : {"-3.40282e+38\n1 2\n-3.4028234663852886e38 4\n", "-9999.9\n1 2\n-9999.900390625 4\n"}) {
    EXPECT_TRUE(std::isnan(heights_of(*grid(head + data))[0][0])) << data;
  }
}

TEST(TableSurface, HeadsOfAnotherNumberOfCells) {
  // More heads than rows decide how many cells are usual: their names are not those of the rows.
  Warnings warnings;
  expect_grid(*grid("a,b,c\nd,e,f\ng,h,i\n1,2\n3,4\n", warnings), {0, 1}, {0, 1}, {{1, 2}, {3, 4}});
  EXPECT_EQ(warnings.left_out().text(), "left out: 3 lines above the first row");
  for (const char* file : {"head_wider_than_rows.csv", "names_fewer_than_cells.txt", "names_of_prose.txt",
                           "head_of_bytes.txt", "frame_of_other_names.txt"}) {
    EXPECT_FALSE(grid_error(corpus_file(file)).empty()) << file;
  }
}

}  // namespace
}  // namespace ligne
