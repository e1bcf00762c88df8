// Readers of text formats: OBJ with its libraries, 3MF and its archive; and the faults that every format can have, told
// alike in all of them: coordinates that are no finite numbers, and files without a face (docs/scene-format.md, "Faults").

#include "gltf_builder.hpp"
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

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

/// The y of the second of three vertices, and its x: as a text may have them, and as a binary file may.
struct BadNumber {
  std::string text;
  float value, x_value = 1;
  std::string x = "1";
};
const BadNumber kGood{"0", 0}, kBadNumbers[] = {{"nan", kNan}, {"-inf", -kInfinity}, {"1e999", kInfinity}};

/// A triangle of one format, or its vertices alone.
struct Format {
  const char* name;
  ModelFormat format;
  std::string place;  ///< of the vertex, in errors
  std::function<std::string(const BadNumber& y, bool with_face)> write;
};

std::string stl_bytes(const BadNumber& y, std::uint32_t n) {
  std::string out(80, ' ');
  const auto put = [&out](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof value);
  };
  put(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, y.x_value, y.value, 0.f, 0.f, 1.f, 0.f}) put(v);
    put(std::uint16_t{0});
  }
  return out;
}

std::string ply_header(const char* encoding, bool with_face) {
  return std::string("ply\nformat ") + encoding +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         (with_face ? "1" : "0") + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply_bytes(const BadNumber& y, bool with_face) {
  std::string out = ply_header("binary_little_endian", with_face);
  const float numbers[] = {0, 0, 0, y.x_value, y.value, 0, 0, 1, 0};
  out.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  const std::int32_t corners[] = {0, 1, 2};
  if (with_face) out.append(1, '\3').append(reinterpret_cast<const char*>(corners), sizeof corners);
  return out;
}

gltf_test::Builder gltf(const BadNumber& y, bool with_face) {
  gltf_test::Builder b;
  const int positions = b.accessor<float>({0, 0, 0, y.x_value, y.value, 0, 0, 1, 0}, 3);
  b.mesh(positions, -1, with_face ? 4 : 0);
  return b;
}

const Format kFormats[] = {
    {"Obj", ModelFormat::obj, "M:2: ",
     [](const BadNumber& y, bool with_face) {
       return "v 0 0 0\nv " + y.x + " " + y.text + " 0\nv 0 1 0\n" + (with_face ? "f 1 2 3\n" : "");
     }},
    {"StlText", ModelFormat::stl_ascii, "M:5: ",
     [](const BadNumber& y, bool with_face) {
       const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " + y.x + " " + y.text +
                                 " 0\nvertex 0 1 0\nendloop\nendfacet\n";
       return "solid a\n" + (with_face ? facet : "") + "endsolid a\n";
     }},
    {"StlBinary", ModelFormat::stl_binary,
     "M: triangle 0 of 1: ", [](const BadNumber& y, bool with_face) { return stl_bytes(y, with_face ? 1 : 0); }},
    {"PlyText", ModelFormat::ply, "M:11: ",
     [](const BadNumber& y, bool with_face) {
       return ply_header("ascii", with_face) + "0 0 0\n" + y.x + " " + y.text + " 0\n0 1 0\n" +
              (with_face ? "3 0 1 2\n" : "");
     }},
    {"PlyBinary", ModelFormat::ply,
     "M: vertex 1 of 3: ", [](const BadNumber& y, bool with_face) { return ply_bytes(y, with_face); }},
    {"Gltf", ModelFormat::gltf, "M: accessor 0: position 1 ",
     [](const BadNumber& y, bool with_face) { return gltf(y, with_face).text(); }},
    {"Glb", ModelFormat::glb, "M: accessor 0: position 1 ",
     [](const BadNumber& y, bool with_face) { return gltf(y, with_face).glb(); }},
    {"Asc", ModelFormat::asc_3d_studio, "M:5: ",
     [](const BadNumber& y, bool with_face) {
       return std::string("Named object: \"a\"\nTri-mesh, Vertices: 3 Faces: ") + (with_face ? "1" : "0") +
              "\nVertex list:\nVertex 0: X: 0 Y: 0 Z: 0\nVertex 1: X: " + y.x + " Y: " + y.text +
              " Z: 0\nVertex 2: X: 0 Y: 1 Z: 0\nFace list:\n" + (with_face ? "Face 0: A:0 B:1 C:2\n" : "");
     }},
    {"LigneScene", ModelFormat::ligne_scene, "M:3: ", [](const BadNumber& y, bool with_face) {
       return "{\"format\":\"ligne-scene\",\"version\":1,\"objects\":[\n{\"vertices\":[[0,0,0],\n[" + y.x + "," + y.text +
              ",0],[0,1,0]],\n\"faces\":[" + (with_face ? "{\"outer\":[0,1,2]}" : "") + "]}]}";
     }}};

/// The error line; else the warnings, one a line, and the number of faces that are left.
std::string outcome(const Format& format, const std::string& file) {
  Warnings warnings;
  try {
    const Scene scene = read_scene({bytes_of(file), "M"}, format.format, {}, warnings);
    std::string text;
    for (const auto& [kind, count] : warnings.counts()) text += std::to_string(count) + " " + kind + "; ";
    return text + std::to_string(scene.faces.size()) + " faces";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Faults, AGoodTriangleIsRead) {
  for (const Format& format : kFormats) EXPECT_EQ(outcome(format, format.write(kGood, true)), "1 faces") << format.name;
}

TEST(Faults, CoordinatesThatAreNotFiniteAreErrorsThatNameThePlace) {
  for (const Format& format : kFormats) {
    for (const BadNumber& bad : kBadNumbers) {
      for (const bool used : {true, false}) {
        if (!used && std::string(format.name).starts_with("Stl")) continue;  // no vertex without a face
        if (!used && std::string(format.name).starts_with("Gl")) continue;   // positions of points are not read
        const std::string line = outcome(format, format.write(bad, used));
        EXPECT_TRUE(line.starts_with(format.place)) << format.name << ", " << bad.text << ": " << line;
      }
    }
  }
}

TEST(Faults, FilesWithoutAFaceAreErrors) {
  for (const Format& format : kFormats) {
    // A glTF names points as such.
    const bool points = std::string(format.name).starts_with("Gl");
    EXPECT_EQ(outcome(format, format.write(kGood, false)),
              std::string("M: holds no faces") + (points ? "; left out: 1 primitive of points" : ""))
        << format.name;
  }
}

TEST(Faults, FilesOfFacesWithoutAnAreaAreErrors) {
  const BadNumber first_again{"0", 0, 0, "0"};
  for (const Format& format : kFormats)
    EXPECT_EQ(outcome(format, format.write(first_again, true)),
              "M: none of its 1 faces has an area: they are lines or points")
        << format.name;
}

TEST(Faults, ATransformBeyondAllNumbersIsAnError) {
  gltf_test::Builder b = gltf_test::square();
  b.root["nodes"][0]["scale"] = {1e308, 1, 1};
  b.root["nodes"][0]["translation"] = {1e308, 0, 0};
  const Format& format = kFormats[5];
  EXPECT_EQ(outcome(format, b.text()), "M: vertex 0 of 4: a coordinate is beyond 1.6e60, too large to compute with");
}

// Numbers, material libraries and free-form surfaces of OBJ files.

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
  const Result r = read("mtllib red glass.mtl # comment\n" + square_ + "usemtl glass\nf 1 2 3\nusemtl tinted\nf 1 3 4\n");
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
            "left out: 2 textures (map_Kd), 1 texture (norm), 1 statement 'wobble' of materials, 1 missing library "
            "'missing.mtl', 1 missing library '../a.mtl'");
}

TEST_F(ObjLibraries, BrokenNumbersNameTheLine) {
  write("a.mtl", "newmtl m\nKd one 1 1\n");
  test::expect_parts(error_line([&] { read("mtllib .\\a.mtl\n" + square_ + "usemtl m\nf 1 2 3\n"); }),
                     {"a.mtl:2: 'one' is not a number of a material"});
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
