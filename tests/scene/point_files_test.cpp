// Points and lines in files of arrays and archives.

#include "array_builder.hpp"
#include "deflated.hpp"
#include "height_tools.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "zip_builder.hpp"

namespace ligne {
namespace {

using namespace array_test;
using height_test::error_line;
using height_test::kNaN;
using test::deflated;

class PointFiles : public testing::Test {
 protected:
  void write(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    warnings_ = {};
  }
  std::vector<LabelledPoint> points(const std::string& bytes) {
    write(bytes);
    InputFiles opened;
    return read_points(file_, opened, warnings_);
  }
  std::vector<std::vector<Point3>> lines(const std::string& bytes) {
    write(bytes);
    InputFiles opened;
    return read_lines(file_, opened, warnings_);
  }
  /// The message behind the name of the file.
  std::string error(const std::string& bytes) {
    const std::string message = error_line([&] { points(bytes); });
    EXPECT_TRUE(message.starts_with(file_ + ": ")) << message;
    return message.substr(std::min(message.size(), file_.size() + 2));
  }
  void expect_two(const std::vector<LabelledPoint>& found, double z, const std::string& label) {
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].at.x, 1);
    EXPECT_EQ(found[0].at.y, 3);
    EXPECT_EQ(found[1].at.x, 2);
    EXPECT_EQ(found[1].at.y, 4);
    EXPECT_TRUE(std::isnan(z) ? std::isnan(found[0].at.z) : found[0].at.z == z);
    EXPECT_EQ(found[0].label, label);
  }

  test::TemporaryFolder folder_;
  std::string file_ = (folder_ / "points").string();
  Warnings warnings_;
};

TEST_F(PointFiles, Archives) {
  const std::string text = "name,x,y\nHof,1,3\nUlm,2,4\n";
  expect_two(points(deflated(text, 31)), kNaN, "Hof");
  expect_two(points(zip_test::zip({{"places.csv", text}})), kNaN, "Hof");
  EXPECT_EQ(error(zip_test::zip({{"a.csv", text}, {"b.csv", text}})),
            "is a ZIP archive of 2 files: unpack it, and take one of them");
  EXPECT_EQ(error(deflated(deflated(text, 31), 31)), "is an archive within an archive: unpack it");
}

TEST_F(PointFiles, Npy) {
  expect_two(points(npy("<f8", "2, 2", numbers<double>({1, 3, 2, 4}))), kNaN, "");
  expect_two(points(npy("<f8", "2, 3", numbers<double>({1, 3, 9, 2, 4, 8}))), 9, "");
  EXPECT_EQ(warnings_.lines(), std::vector<std::string>{"3 columns of the array read as x, y and z"});
  EXPECT_EQ(error(npy("<f8", "2, 4", numbers<double>({1, 3, 9, 2, 4, 8, 0, 0}))),
            "holds no points: arrays x and y, or rows of x, y and perhaps z; there are array of 2 x 4");
}

TEST_F(PointFiles, Matlab) {
  const std::string x = mat_matrix("lon", 2, 1, numbers<double>({1, 2})),
                    y = mat_matrix("lat", 1, 2, numbers<double>({3, 4}));
  expect_two(points(mat_head() + x + y + mat_matrix("z", 2, 1, numbers<double>({9, 8}))), 9, "");
  expect_two(points(mat_head() + x + y + mat_matrix("dem", 2, 2, numbers<double>({9, 8, 7, 6}))), kNaN, "");
  EXPECT_EQ(warnings_.left_out().text(), "left out: 1 array (dem)");
  EXPECT_EQ(error(mat_head() + x + mat_matrix("lat", 1, 3, numbers<double>({3, 4, 5}))),
            "arrays lon and lat have different lengths: they are not positions of points");
}

TEST_F(PointFiles, LinesOfArchives) { EXPECT_EQ(lines(deflated("0 0\n1 0\n\n2 2\n3 3\n", 31)).size(), 2u); }

TEST_F(PointFiles, RecordsOfFewMembersAreRefused) {
  std::string records = "[{";
  for (int k = 0; k < 1000; ++k) records += (k ? "," : "") + std::string("\"k") + std::to_string(k) + "\":1";
  records += "}";
  for (int k = 0; k < 1000; ++k) records += ",{}";
  EXPECT_EQ(error(records + "]"), "is a JSON list of records in which most members are missing");
}

}  // namespace
}  // namespace ligne
