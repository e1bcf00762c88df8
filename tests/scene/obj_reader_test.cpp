// Numbers, material libraries and free-form surfaces of OBJ files.

#include "scene/readers/obj/obj_reader.hpp"
#include "reader_tools.hpp"
#include "scene/readers/ligne_scene_reader.hpp"
#include "scene/readers/obj/obj_materials.hpp"

namespace ligne::reader_test {
namespace {

class ObjLibraries : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) { folder_.write(name, text); }
  Result read(const std::string& text) {
    Result r;
    r.scene = read_obj({bytes_of(text), "M", folder_}, r.report, r.warnings);
    return r;
  }

  const test::TemporaryFolder folder_;
  const std::string square_ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
};

TEST_F(ObjLibraries, GiveColourAndOpacity) {
  write("red glass.mtl", "# by hand\nnewmtl glass\nKd 1 0 0.25\nd 0.5\nTr 0.9\nillum 2\nnewmtl\ttinted\nKd 0.5\nTr 0.25\n");
  const Result r = read("mtllib red glass.mtl\n" + square_ + "usemtl glass\nf 1 2 3\nusemtl tinted\nf 1 3 4\n");
  ASSERT_EQ(r.scene.materials.size(), 2u);
  EXPECT_EQ(r.scene.materials[0].name, "glass");
  EXPECT_EQ(r.scene.materials[0].color, Point3(1, 0, 0.25));
  EXPECT_EQ(r.scene.materials[0].opacity, 0.5);
  EXPECT_EQ(r.scene.materials[1].color, Point3(0.5, 0.5, 0.5));
  EXPECT_EQ(r.scene.materials[1].opacity, 0.75);
  EXPECT_TRUE(r.warnings.lines().empty());
  ASSERT_EQ(r.report.files.size(), 1u);
  EXPECT_EQ(r.report.files[0].filename(), "red glass.mtl");
}

TEST_F(ObjLibraries, NameWhatIsLeftOut) {
  write("a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd wood.png\nmap_Kd -s 2 2 wood.png\nnorm n.png\nwobble 1\n");
  const Result r = read("mtllib a.mtl missing.mtl ../a.mtl\n" + square_ + "usemtl m\nf 1 2 3\n");
  EXPECT_EQ(r.warnings.left_out().text(),
            "left out: 2 textures (map_Kd), 1 textures (norm), 1 statements 'wobble' of materials, 1 missing libraries "
            "'missing.mtl', 1 missing libraries '../a.mtl'");
}

TEST_F(ObjLibraries, BrokenNumbersNameTheLine) {
  write("a.mtl", "newmtl m\nKd one 1 1\n");
  try {
    read("mtllib .\\a.mtl\n" + square_ + "usemtl m\nf 1 2 3\n");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.mtl:2: 'one' is not a number of a material"), std::string::npos);
  }
}

Scene plain(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_obj({bytes, name}, report, warnings);
}

TEST(ObjReader, NumbersAreRoundedCorrectly) {
  for (const std::string word :
       {"0.1234567890123456", "-149.29088", "123456.789012", "1e-3", "+2.5", "5e-324", "1e-400", ".5", "7."}) {
    const Result r = read_raw(plain, "v " + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(r.scene.vertices[0].x, std::strtod(word.c_str(), nullptr)) << word;
  }
}

TEST(ObjReader, LongWordsAreShownByTheirBeginnings) {
  EXPECT_EQ(error_of(plain, "v 0 0 " + std::string(100, 'x')),
            "M:1: '" + std::string(40, 'x') + "...' is not a coordinate of a vertex");
  EXPECT_EQ(error_of(read_ligne_scene, std::string(1000000, '[')), "M: JSON nested deeper than 32 levels");
}

/// A quarter of a cylinder as a rational patch: its points lie on the circle.
TEST(ObjSurfaces, RationalBSplineIsACylinder) {
  const std::string text =
      "v 1 0 0\nv 1 1 0 0.70710678118654757\nv 0 1 0\nv 1 0 2\nv 1 1 2 0.70710678118654757\nv 0 1 2\n"
      "cstype rat bspline\ndeg 2 1\nsurf 0 1 0 1 1 2 3 -3 -2 -1\nparm u 0 0 0 1 1 1\nparm v 0 0 1 1\nend\n";
  const Result r = read_raw(plain, text);
  EXPECT_EQ(r.scene.faces.size(), 2u * 12);
  for (const Point3& p : r.scene.vertices) EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-15);
}

}  // namespace
}  // namespace ligne::reader_test
