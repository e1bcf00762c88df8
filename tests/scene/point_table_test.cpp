#include "scene/surfaces/grids/point_table.hpp"

#include "height_tools.hpp"

namespace ligne {
namespace {

using height_test::error_line;

class PointTable : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::vector<LabelledPoint> points(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    warnings_ = {};
    InputFiles opened;
    return read_points(file_, opened, warnings_);
  }
  std::vector<std::vector<Point3>> lines(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    warnings_ = {};
    InputFiles opened;
    return read_lines(file_, opened, warnings_);
  }
  static void expect_point(const LabelledPoint& point, double x, double y, double z, const std::string& label) {
    EXPECT_EQ(point.at.x, x);
    EXPECT_EQ(point.at.y, y);
    EXPECT_TRUE(std::isnan(z) ? std::isnan(point.at.z) : point.at.z == z) << point.at.z;
    EXPECT_EQ(point.label, label);
  }

  std::string file_ = (std::filesystem::temp_directory_path() / ("ligne_points_" + std::to_string(getpid()))).string();
  Warnings warnings_;
};

TEST_F(PointTable, ColumnsByName) {
  const auto found = points("id,lon,lat,label\n1,-1,1,\"KM, CM\"\n2,0,0.5,Bonn\n");
  ASSERT_EQ(found.size(), 2u);
  expect_point(found[0], -1, 1, height_test::kNaN, "KM, CM");
  expect_point(found[1], 0, 0.5, height_test::kNaN, "Bonn");
  EXPECT_EQ(warnings_.left_out().text(), "left out: 1 column (id)");
  expect_point(points("name,x,y\nHof,-1,1\n")[0], -1, 1, height_test::kNaN, "Hof");
  expect_point(points("lat;lon;height (m)\n1,5;2,5;100\n")[0], 2.5, 1.5, 100, "");
}

TEST_F(PointTable, NamesAtTheEndOfARowHaveBlanks) {
  const auto found = points("x y name\n2.5 1.5 Great Horn\n0.2 -3.4 Mill\n5 -3 Ferry\n");
  ASSERT_EQ(found.size(), 3u);
  expect_point(found[0], 2.5, 1.5, height_test::kNaN, "Great Horn");
  expect_point(found[1], 0.2, -3.4, height_test::kNaN, "Mill");
}

TEST_F(PointTable, RowsWithoutNames) {
  const auto found = points("0,5;0,5;Bonn\n-1;1;KM-CM\n2;3;4;Hof\n2;3;;Ulm\n");
  ASSERT_EQ(found.size(), 4u);
  expect_point(found[0], 0.5, 0.5, height_test::kNaN, "Bonn");
  expect_point(found[2], 2, 3, 4, "Hof");
  expect_point(found[3], 2, 3, height_test::kNaN, "Ulm");
  expect_point(points("1 2 Bad Homburg\n3 4 5 Am Main\n")[1], 3, 4, 5, "Am Main");
  expect_point(points("Hof,1,2\nUlm,3,4\n")[1], 3, 4, height_test::kNaN, "Ulm");
}

TEST_F(PointTable, RowsWithoutAPositionAreCounted) {
  EXPECT_EQ(points("x,y,name\n1,2,a\nNA,3,b\n4,,c\n").size(), 1u);
  EXPECT_EQ(warnings_.left_out().text(), "left out: 2 rows without x or y");
  EXPECT_NE(error_line([&] { points("1 2\n3 here\n"); }).find(":2: does not begin with two numbers, x and y"),
            std::string::npos);
  EXPECT_NE(error_line([&] { points("a\nb\n"); }).find("no line holds one"), std::string::npos);
}

TEST_F(PointTable, LinesEndAtBlankLinesAndMissingPositions) {
  const auto found = lines("# coast\n0 0\n1 0\n\n2 2 5\n3 3 5\nnan nan\n4 4 5\n5 5 5\n6 6 5\n\n9 9\n");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[1].size(), 2u);
  EXPECT_EQ(found[1][0], (Point3{2, 2, 5}));
  EXPECT_EQ(found[2].size(), 3u);
}

}  // namespace
}  // namespace ligne
