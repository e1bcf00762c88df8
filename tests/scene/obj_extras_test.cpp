// Material libraries and free-form surfaces of OBJ files.

#include "reader_tools.hpp"
#include "scene/readers/obj/obj_materials.hpp"
#include "scene/readers/obj/obj_reader.hpp"

namespace ligne::reader_test {
namespace {

class ObjLibraries : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  Result read(const std::string& text) {
    Result r;
    r.scene = read_obj({bytes_of(text), "M", folder_}, r.report, r.warnings);
    return r;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("ligne_obj_libraries_" + std::to_string(::getpid()));
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

TEST_F(ObjLibraries, ColoursOfVerticesMayBeUnknown) {
  const Result r = read("v 0 0 0 nan nan nan\nv 1 0 0 NaN -nan inf 1\nv 1 1 0 0.5 0.5 0.5\nf 1 2 3\n");
  EXPECT_EQ(r.scene.vertices[1], Point3(1, 0, 0));
  for (const char* line : {"v 0 nan 0\n", "v 0 0 0 nan\n", "v 0 0 0 red 0 0\n"}) {
    EXPECT_THROW(read(line + square_ + "f 1 2 3\n"), InputError) << line;
  }
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

const std::string kPatchPoints =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 1\nv 2 1 2\nv 3 1 0\n"
    "v 0 2 0\nv 1 2 2\nv 2 2 1\nv 3 2 0\nv 0 3 0\nv 1 3 0\nv 2 3 0\nv 3 3 0\n";

TEST(ObjSurfaces, BezierPatchIsTessellated) {
  const Result r = read_raw(plain, kPatchPoints +
                                       "cstype bezier\ndeg 3 3\nsurf 0 1 0 1 13 14 15 16 9 10 11 12 5 6 7 8 1 2 3 4\n"
                                       "parm u 0 1\nparm v 0 1\nend\n");
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.faces.size(), 2u * 12 * 12);
  EXPECT_TRUE(r.warnings.lines().empty());
  // The middle of a bicubic patch: the control points with the weights 1 3 3 1 in both directions, by 64.
  const double middle = (9.0 * (1 + 2 + 2 + 1)) / 64;
  const auto at = std::ranges::find_if(r.scene.vertices, [](const Point3& p) { return p.x == 1.5 && p.y == 1.5; });
  ASSERT_NE(at, r.scene.vertices.end());
  EXPECT_NEAR(at->z, middle, 1e-15);
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

TEST(ObjSurfaces, WhatCanNotBeReadIsNamed) {
  EXPECT_EQ(error_of(plain, kPatchPoints + "cstype cardinal\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\n"),
            "M: holds no faces; left out: 1 surfaces (surf) of cstype cardinal");
  const std::string head = kPatchPoints + "cstype bezier\ndeg 3 3\n";
  EXPECT_EQ(error_of(plain, head + "surf 0 1 0 1 1 2 3\nparm u 0 1\nparm v 0 1\nend\n"),
            "M:22: surf with 3 control points, needs 16");
  EXPECT_EQ(error_of(plain, head + "surf 0 1 0 1 1 99\n"), "M:19: surf names vertex 99 of 16");
  EXPECT_EQ(error_of(plain, head + "surf 1 0 0 1 1 2\n"), "M:19: surf without a range of its parameters");
  EXPECT_EQ(error_of(plain, head + "surf 0 1 0 1 1\nparm u 0\nend\n"), "M:21: surf with too few numbers in its parm u");
  EXPECT_EQ(error_of(plain, head + "surf 0 1 0 1 1\nparm u 0 zero\n"), "M:20: parm has a value that is not a number");
  EXPECT_EQ(error_of(plain, kPatchPoints + "cstype bezier\ndeg 0 3\nsurf 0 1 0 1 1\nparm u 0 1\nend\n"),
            "M:21: surf of a degree that is not 1 to 24");
  EXPECT_EQ(error_of(plain, kPatchPoints + "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1 0 1\nend\n"),
            "M:21: surf whose parm u does not ascend");
}

}  // namespace
}  // namespace ligne::reader_test
