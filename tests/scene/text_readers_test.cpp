// Readers of text formats: OBJ with its libraries, 3MF and its archive. Faults that all formats can have:
// scripts/faults.txt.

#include "reader_tools.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/ligne_scene_reader.hpp"
#include "scene/readers/obj/obj_materials.hpp"
#include "scene/readers/obj/obj_reader.hpp"
#include "scene/readers/three_mf/three_mf_reader.hpp"
#include "scene/readers/zip_archive.hpp"
#include "zip_builder.hpp"

namespace ligne::reader_test {
namespace {

// Numbers and free-form surfaces of OBJ files.

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

TEST(ObjReader, KnowsFloat32NumbersOfDifferentSizes) {
  std::string text, face = "f";
  for (int i = 1; i <= 32; ++i) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "v %.6f %.6f 0\n", static_cast<float>(150 + std::sin(i)),
                  static_cast<float>(10 + std::cos(i)));
    text += line.data();
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(read_raw(plain, text + face + "\n").scene.objects[0].precision, half_ulp_float32(150));
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

using zip_test::three_mf;
using zip_test::zip;

const std::string kMesh =
    "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></vertices>"
    "<triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>";

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return "<?xml version='1.0'?><model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' " + attributes +
         "><metadata name='Title'>x</metadata><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

Result read_mf(const std::string& bytes) { return read_raw(read_three_mf, bytes); }
std::string mf_error(const std::string& root) { return error_of(read_three_mf, three_mf(root)); }

TEST(ThreeMfReader, MeshesOfTheBuild) {
  const std::string text = model("<object id='7' name='tri'>" + kMesh + "</object><object id='8'>" + kMesh + "</object>",
                                 "<item objectid='7'/>", "unit='inch'");
  for (const bool packed : {false, true}) {
    for (const bool wide : {false, true}) {
      const std::string bytes = three_mf(text, packed, wide);
      EXPECT_EQ(detect_format(bytes_of(bytes), "", "M"), ModelFormat::three_mf);
      const Result r = read_mf(bytes);
      expect_sound(r.scene);
      EXPECT_EQ(r.scene.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
      EXPECT_EQ(r.scene.objects.at(0).name, "tri");
      EXPECT_EQ(r.scene.unit_mm, 25.4);
      EXPECT_EQ(r.scene.up_axis, Axis::z);
      EXPECT_TRUE(r.warnings.lines().empty());
    }
  }
}

TEST(ThreeMfReader, ObjectsOfOtherParts) {
  std::string root =
      model("<object id='1'><components><component p:path='/3D/Objects/o.model' objectid='5'/></components></object>",
            "<item objectid='1'/>", "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'");
  const std::string bytes =
      zip({{"3D/3dmodel.model", root}, {"3D/Objects/o.model", model("<object id='5'>" + kMesh + "</object>", "")}});
  EXPECT_EQ(read_mf(bytes).scene.faces.size(), 1u);
}

/// Objects that hold others twice, twenty-nine levels deep, stand for half a thousand million.
TEST(ThreeMfReader, FewObjectsDoNotBecomeMillions) {
  std::string resources = "<object id='0'>" + kMesh + "</object>";
  for (int i = 1; i < 30; ++i) {
    const std::string component = "<component objectid='" + std::to_string(i - 1) + "'/>";
    resources += "<object id='" + std::to_string(i) + "'><components>" + component + component + "</components></object>";
  }
  EXPECT_EQ(mf_error(model(resources, "<item objectid='29'/>")), "M: there are too many repeated objects");
}

TEST(ZipArchive, BrokenArchivesAreRefused) {
  EXPECT_EQ(error_of(read_three_mf, zip({{"a.txt", "hello"}})), "M: is a ZIP archive without a 3MF model");
  const std::string good = zip({{"a", "hello hello hello hello"}});
  const ZipArchive archive(bytes_of(good), "Z");
  ASSERT_EQ(archive.entries().size(), 1u);
  EXPECT_EQ(archive.read(archive.entries()[0]).size(), 23u);
  for (std::size_t n = 0; n < good.size(); ++n) EXPECT_THROW(ZipArchive(bytes_of(good.substr(0, n)), "Z"), InputError) << n;
  // Whatever byte is changed, it is read or refused.
  for (std::size_t n = 0; n < good.size(); ++n) {
    for (const char change : {'\x00', '\x7f', '\xff'}) {
      std::string bad = good;
      bad[n] = change;
      try {
        const ZipArchive changed(bytes_of(bad), "Z");
        for (const ZipEntry& entry : changed.entries()) changed.read(entry);
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace ligne::reader_test
