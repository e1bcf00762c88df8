#include "scene/readers/off_reader.hpp"

#include "reader_tools.hpp"

namespace ligne::reader_test {
namespace {

const std::string kFour = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string off_error(const std::string& text) { return error_of(read_off, text); }

TEST(OffReader, PolygonsInAllHabitsOfWriting) {
  for (const std::string head : {"OFF\n4 2 0\n", "OFF 4 2 0\n", "4 2 0\n", "# a comment\nOFF # another\n\n4 2\n"}) {
    const Result r = read_raw(read_off, head + kFour + "4 0 1 2 3\n3 0 1 2 # face\n");
    expect_sound(r.scene);
    ASSERT_EQ(r.scene.faces.size(), 2u) << head;
    EXPECT_EQ(r.scene.faces.contour(0, 0).size(), 4u);
    EXPECT_EQ(r.scene.up_axis, Axis::z);
    EXPECT_TRUE(r.warnings.lines().empty());
  }
}

TEST(OffReader, FacesMayTakeSeveralLines) {
  const Result r = read_raw(read_off, "OFF\n4 2 0\n" + kFour + "4 0 \n1\n2 3\n3 0 1 2\n");
  ASSERT_EQ(r.scene.faces.size(), 2u);
  EXPECT_EQ(r.scene.faces.contour(0, 0).size(), 4u);
  EXPECT_EQ(off_error("OFF\n4 2 0\n" + kFour + "4 0 1 2\n3 0 1 2\n"), "M:8: face from line 7 on ends within this line");
}

TEST(OffReader, VerticesMayHaveMoreThanCoordinates) {
  const std::string more = "0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n";
  for (const std::string word : {"COFF", "NOFF", "STCNOFF"}) {
    EXPECT_EQ(read_raw(read_off, word + "\n3 1 0\n" + more + "3 0 1 2\n").scene.vertices[1], Point3(1, 0, 0)) << word;
    EXPECT_EQ(detect_format(bytes_of(word + "\n3 1 0\n"), "", "M"), ModelFormat::off);
  }
  EXPECT_EQ(detect_format(bytes_of("4 2 0\n"), ".OFF", "M"), ModelFormat::off);
}

TEST(OffReader, ColoursOfFacesAreMaterials) {
  const Result r = read_raw(
      read_off, "OFF\n4 5 0\n" + kFour + "3 0 1 2 255 0 0\n3 0 2 3 1.0 0 0 0.5\n3 0 1 3\n3 1 2 3 7\n3 0 1 2 255 0 0\n");
  ASSERT_EQ(r.scene.materials.size(), 3u);
  EXPECT_EQ(r.scene.materials[0].color, Point3(1, 0, 0));
  EXPECT_EQ(r.scene.materials[0].opacity, 1);
  EXPECT_EQ(r.scene.materials[1].name, "#ff000080");
  EXPECT_EQ(r.scene.materials[1].opacity, 0.5);
  EXPECT_EQ(r.scene.face_material, (std::vector<std::uint32_t>{0, 1, 2, 2, 0}));
  EXPECT_EQ(r.warnings.left_out().text(), "left out: 1 colours by their number");
}

TEST(OffReader, LinesAndPointsAreLeftOut) {
  EXPECT_EQ(read_raw(read_off, "OFF\n4 3 0\n" + kFour + "2 0 1\n1 0\n3 0 1 2\n").warnings.left_out().text(),
            "left out: 1 faces of two corners, 1 faces of less than two corners");
  EXPECT_EQ(off_error("OFF\n4 1 0\n" + kFour + "2 0 1\n"), "M: holds no faces; left out: 1 faces of two corners");
}

TEST(OffReader, ErrorsNameTheLine) {
  EXPECT_EQ(off_error("OFF\n3 1 0\n0 0 0\n1 0 zero\n"), "M:4: 'zero' is not a coordinate of a vertex");
  EXPECT_EQ(off_error("OFF\n3 1 0\n0 0 0\n1 0\n"), "M:4: '' is not a coordinate of a vertex");
  EXPECT_EQ(off_error("OFF\n4 1 0\n" + kFour + "3 0 1 4\n"), "M:7: face names vertex 4 of 4");
  EXPECT_EQ(off_error("OFF\n4 1 0\n" + kFour + "3 0 1 -1\n"), "M:7: '-1' is not a corner of a face");
  EXPECT_EQ(off_error("OFF\n4 2 0\n" + kFour + "3 0 1 2\n"), "M:7: the file ends early");
  EXPECT_EQ(off_error("OFF\n4 1 0\n" + kFour + "3 0 1 2\n3 0 1 3\n"),
            "M:8: more lines than the header declares vertices and faces");
  EXPECT_EQ(off_error("OFF BINARY\n"), "M:1: binary OFF is not read: convert it to text, or to PLY");
  EXPECT_EQ(error_line([] { detect_format(bytes_of(std::string("OFF BINARY\n\0\0\0\3", 15)), "", "M"); }),
            "M: is a binary OFF file, which is not read: convert it to text, or to PLY");
  EXPECT_EQ(off_error("4OFF\n1 1 1\n"), "M:1: '4OFF' has more than three dimensions, and is not read");
  EXPECT_EQ(off_error("OFF\n99999999999 1 0\n"), "M:2: too many vertices or faces");
  EXPECT_EQ(off_error("OFF\n1000000000 1 0\n0 0 0\n"), "M:3: the file ends early");
}

}  // namespace
}  // namespace ligne::reader_test
