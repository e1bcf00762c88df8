/// ligne draw --zbuffer-save and --zbuffer-add.

#include <cmath>

#include "draw_program.hpp"
#include "forged_files.hpp"
#include "picture/raster/zbuffer_picture.hpp"

namespace ligne::test {
namespace {

/// A plate with two posts, so that what is put on the plate changes neither the middle of the scene nor its size on the
/// page.
constexpr const char* kPlate = R"(v 0 0 0
v 0 0 10
v 10 0 10
v 10 0 0
v 9 0 9
v 9 8 9
v 10 8 10
v 1 0 1
v 1 8 1
v 0 8 0
f 1 2 3 4
f 3 5 6 7
f 1 8 9 10
)";
/// A tetrahedron, and a plate that cuts it.
constexpr const char* kStone = R"(v 2 0 2
v 5 0 3
v 3 0 6
v 3 4 4
f 1 2 3
f 1 2 4
f 2 3 4
f 3 1 4
)";
constexpr const char* kBoard = R"(v 1 1 3
v 7 2 3
v 7 2 5
v 1 1 5
f 1 2 3 4
)";

class ZBufferFileTest : public DrawTest {
 protected:
  void SetUp() override {
    DrawTest::SetUp();
    write("plate.obj", kPlate);
    write("stone.obj", kStone);
    write("board.obj", kBoard);
  }
  std::string bytes_of(const Words& arguments, const std::string& output) const {
    const Outcome outcome = run_well("draw -q" + arguments + Words{"-o", output});
    return contents(file(output));
  }
  std::string refusal(const Words& arguments) const {
    const Outcome outcome = run("draw" + arguments);
    EXPECT_NE(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    return outcome.err;
  }
};

TEST_F(ZBufferFileTest, AddedObjectsGiveThePictureOfAll) {
  for (const Words view :
       {"--view iso", "--eye 20,14,25 --target 5,3,5 --fov 30", "--view top --set filling=fixed --edges all"}) {
    for (const std::string output : {"a.svg", "a.json", "a.pdf"}) {
      bytes_of(view + "plate.obj --lines 300 --zbuffer-save plate.zbuf", output);
      Words more;
      more.assign(view.begin() + (view[0] == "--eye" ? 6 : 2), view.end());
      bytes_of(more + "stone.obj --zbuffer-add plate.zbuf --zbuffer-save stone.zbuf", output);
      const std::string one_by_one = bytes_of(more + "board.obj --zbuffer-add stone.zbuf", output),
                        in_two = bytes_of(more + "stone.obj board.obj --zbuffer-add plate.zbuf", output);
      // The statistics of a JSON drawing tell how much was painted.
      const auto drawn = [&](const std::string& bytes) {
        if (output != "a.json") return bytes;
        json drawing = json::parse(bytes);
        drawing.erase("stats");
        return drawing.dump();
      };
      const std::string at_once =
          drawn(bytes_of(view + "plate.obj stone.obj board.obj --lines 300 --method zbuffer", output));
      EXPECT_EQ(drawn(one_by_one), at_once) << view[1] << " " << output;
      EXPECT_EQ(drawn(in_two), at_once) << view[1] << " " << output;
    }
  }
}

TEST_F(ZBufferFileTest, DamagedAndForgedFilesAreReadOrRefused) {
  bytes_of("plate.obj --zbuffer-save plate.zbuf --lines 5", "a.svg");
  const std::string bytes = contents(file("plate.zbuf"));
  const auto error_of = [&](const std::string& changed) {
    write("changed.zbuf", changed);
    return refusal("stone.obj --zbuffer-add changed.zbuf -o b.svg");
  };
  const std::string damaged = "ligne: changed.zbuf: byte 12: the file was changed or cut off since it was written\n";
  EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2)), damaged);
  EXPECT_EQ(error_of(bytes + "x"), damaged);
  std::string other = bytes;
  other[12] = 7;
  expect_parts(error_of(other), {"a depth buffer of version 7; this program reads version 1"});
  expect_forgeries_are_refused(bytes, sign_zbuffer, ZBuffer::read);
}

/// A line behind a plate, here two sides of another one, is drawn to the plate's border at least, and by less than two
/// pixels too far: it counts as hidden only where the faces about it hide all of it.
TEST_F(ZBufferFileTest, LinesReachWhatHidesThem) {
  write("behind.obj", R"(v -1 -1 0
v 1 -1 0
v 1.03 1 0
v -1.06 1 0
v -3 -0.7 -1
v 3 0.8 -1
v -3 0.95 -1
v 3 -0.9 -1
f 1 2 3 4
f 5 8 6 7
)");
  for (const char* lines : {"90", "128", "200", "331"}) {
    SCOPED_TRACE(lines);
    const auto length_of_lines = [&](const char* method, const Words& options) {
      double length = 0;
      const json drawing = drawn(Words{"behind.obj", "--view", "front", "--method", method, "--quality", "exact"} + options);
      for (const json& stroke : drawing["strokes"]) {
        const json& a = stroke["points"].front();
        const json& b = stroke["points"].back();
        const double dx = b[0].get<double>() - a[0].get<double>(), dy = b[1].get<double>() - a[1].get<double>();
        length += std::hypot(dx, dy);
      }
      return length;
    };
    const double right = length_of_lines("appel", {}), by_pixels = length_of_lines("zbuffer", {"--lines", lines});
    const double pixel_mm = 190 / std::stod(lines);  // of the height of the page between its margins
    EXPECT_GE(by_pixels, right - 0.01);
    EXPECT_LE(by_pixels, right + 4 * 2 * std::sqrt(2) * pixel_mm);
  }
}

}  // namespace
}  // namespace ligne::test
