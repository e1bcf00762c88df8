#include "scene/readers/three_mf/three_mf_reader.hpp"

#include "reader_tools.hpp"
#include "scene/readers/zip_archive.hpp"
#include "zip_builder.hpp"

namespace ligne::reader_test {
namespace {

using zip_test::zip;

const std::string kVertices =
    "<vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></vertices>";
const std::string kMesh = "<mesh>" + kVertices + "<triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>";

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return "<?xml version='1.0'?><model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' " + attributes +
         "><metadata name='Title'>x</metadata><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

std::string archive(const std::string& root, bool packed = true, bool wide = false) {
  return zip({{"[Content_Types].xml", "<Types/>"},
              {"_rels/.rels",
               "<Relationships><Relationship Target='/3D/model one.model' Id='r' "
               "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>"},
              {"3D/model one.model", root}},
             packed, wide);
}

Result read_mf(const std::string& bytes) { return read_raw(read_three_mf, bytes); }
std::string mf_error(const std::string& root) { return error_of(read_three_mf, archive(root)); }

TEST(ThreeMfReader, MeshesOfTheBuild) {
  const std::string text = model("<object id='7' name='tri'>" + kMesh + "</object><object id='8'>" + kMesh + "</object>",
                                 "<item objectid='7'/>", "unit='inch'");
  for (const bool packed : {false, true}) {
    for (const bool wide : {false, true}) {
      const std::string bytes = archive(text, packed, wide);
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

/// A component that is turned by 90 degrees about z, of an object that is moved and mirrored.
TEST(ThreeMfReader, ComponentsHaveTransforms) {
  const Result r = read_mf(
      archive(model("<object id='1'>" + kMesh +
                        "</object><object id='2'><components><component objectid='1' transform='0 1 0 -1 0 0 0 0 1 0 0 0'/>"
                        "<component objectid='1'/></components></object>",
                    "<item objectid='2' transform='-1 0 0 0 1 0 0 0 1 10 20 30'/>")));
  ASSERT_EQ(r.scene.objects.size(), 2u);
  EXPECT_EQ(r.scene.vertices,
            (std::vector<Point3>{{10, 20, 30}, {10, 21, 30}, {11, 20, 30}, {10, 20, 30}, {9, 20, 30}, {10, 21, 30}}));
  const auto corners = r.scene.faces.corners();
  EXPECT_EQ(std::vector<std::uint32_t>(corners.begin(), corners.end()), (std::vector<std::uint32_t>{0, 2, 1, 3, 5, 4}));
}

TEST(ThreeMfReader, ObjectsOfOtherParts) {
  std::string root =
      model("<object id='1'><components><component p:path='/3D/Objects/o.model' objectid='5'/></components></object>",
            "<item objectid='1'/>", "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'");
  const std::string bytes =
      zip({{"3D/3dmodel.model", root}, {"3D/Objects/o.model", model("<object id='5'>" + kMesh + "</object>", "")}});
  EXPECT_EQ(read_mf(bytes).scene.faces.size(), 1u);
}

TEST(ThreeMfReader, Materials) {
  const std::string resources =
      "<basematerials id='1'><base name='wood' displaycolor='#FF0000'/><base name='glass' "
      "displaycolor='#0000FF80'/></basematerials>"
      "<m:colorgroup id='2'><m:color color='#00FF00'/></m:colorgroup>"
      "<object id='3' pid='1' pindex='0'><mesh>" +
      kVertices +
      "<triangles><triangle v1='0' v2='1' v3='2'/><triangle v1='0' v2='1' v3='2' pid='1' p1='1'/>"
      "<triangle v1='0' v2='1' v3='2' pid='2' p1='0'/><triangle v1='0' v2='1' v3='2' pid='9' "
      "p1='0'/></triangles></mesh></object>";
  const Result r = read_mf(archive(model(resources, "<item objectid='3'/>", "xmlns:m='http://m'")));
  ASSERT_EQ(r.scene.materials.size(), 4u);
  EXPECT_EQ(r.scene.materials[0].name, "wood");
  EXPECT_EQ(r.scene.materials[0].color, Point3(1, 0, 0));
  EXPECT_NEAR(r.scene.materials[1].opacity, 128.0 / 255, 1e-15);
  EXPECT_EQ(r.scene.materials[2].color, Point3(0, 1, 0));
  EXPECT_EQ(r.scene.face_material, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(ThreeMfReader, WhatIsLeftOutIsNamed) {
  const std::string resources = "<m:texture2d id='1' path='/t.png'/><w:wobble id='2'/><object id='3' type='support'>" +
                                kMesh + "</object><object id='4'><mesh>" + kVertices +
                                "<triangles><triangle v1='0' v2='1' v3='2'/></triangles><b:beamlattice/></mesh></object>";
  const Result r =
      read_mf(archive(model(resources, "<item objectid='3'/><item objectid='4'/>", "xmlns:m='m' xmlns:w='w' xmlns:b='b'")));
  EXPECT_EQ(r.warnings.left_out().text(), "left out: 1 textures, 1 elements w:wobble, 1 supports, 1 elements b:beamlattice");
}

TEST(ThreeMfReader, BrokenFilesAreRefused) {
  const std::string object = "<object id='1'>" + kMesh + "</object>";
  EXPECT_EQ(mf_error(model(object, "<item objectid='2'/>")), "M: there is no object '2'");
  EXPECT_EQ(mf_error(model(object, "<item objectid='1' transform='1 2 3'/>")),
            "M: the transform of object '1' is not twelve numbers");
  EXPECT_EQ(mf_error(model(object, "<item objectid='1'/>", "unit='ell'")), "M: unit 'ell' is not known");
  EXPECT_EQ(mf_error(model(object, "")), "M: holds no faces");
  EXPECT_EQ(
      mf_error(model("<object id='1'><components><component objectid='1'/></components></object>", "<item objectid='1'/>")),
      "M: object '1' contains itself, or is nested too deeply");
  EXPECT_EQ(mf_error(model("<object id='1'><mesh>" + kVertices +
                               "<triangles><triangle v1='0' v2='1' v3='3'/></triangles></mesh></object>",
                           "<item objectid='1'/>")),
            "M: object '1': triangle 0 names vertex 3 of 3");
  EXPECT_EQ(mf_error(model("<object id='1'><mesh><vertices><vertex x='nan' y='0' z='0'/></vertices></mesh></object>",
                           "<item objectid='1'/>")),
            "M: object '1': 'nan' is not a coordinate of vertex 0");
  EXPECT_TRUE(mf_error("<model").starts_with("M: part '3D/model one.model': broken XML at byte "));
  EXPECT_EQ(error_of(read_three_mf, zip({{"a.txt", "hello"}})), "M: is a ZIP archive without a 3MF model");
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
  const std::string good = zip({{"a", "hello hello hello hello"}});
  const ZipArchive archive(bytes_of(good), "Z");
  ASSERT_EQ(archive.entries().size(), 1u);
  EXPECT_EQ(archive.read(archive.entries()[0]).size(), 23u);
  for (std::size_t n = 0; n < good.size(); ++n) {
    EXPECT_THROW(ZipArchive(bytes_of(good.substr(0, n)), "Z"), InputError) << n;
  }
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
