/// Readers: strange archives, precision, blocks of PLY, text formats.

#include "scene/readers/reader.hpp"
#include "reader_tools.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/obj/obj_materials.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/readers/zip_archive.hpp"
#include "zip_builder.hpp"

namespace ligne {
namespace {

using namespace reader_test;

/// The message about an archive that is known and not read.
std::string refusal(const std::string& bytes) {
  return error_line([&] { detect_format(bytes_of(bytes), "", "M"); });
}

TEST(Strangers, AreNamedWithWhatToDo) {
  const std::string blender = ", which is not read: open it in Blender and export glTF";
  EXPECT_EQ(refusal(zip_test::zip({{"scene.usdc", "PXR-USDC"}}, false)), "M: is a USD file" + blender);
  EXPECT_EQ(refusal(zip_test::zip({{"readme.txt", "hello"}})), "M: is a ZIP archive, not a model");
  EXPECT_TRUE(refusal(zip_test::zip({{"duck.dae", "<COLLADA>"}})).starts_with("M: is an archive with a COLLADA file, "));
  EXPECT_TRUE(refusal(zip_test::zip({{"a.3DRep", "<x/>"}})).starts_with("M: is a 3DXML file, which is not read: "));
}

TEST(Precision, OfFloat32NumbersAsText) {
  // Coordinates of a part far from the origin, as float32 and as double, with so many decimals.
  const auto precision = [](bool as_float32, const char* format, double step) {
    DecimalPrecision p;
    for (int i = 0; i < 64; ++i) {
      const double place = 150 + std::sin(i), value = step > 0 ? std::round(place / step) * step : place;
      std::array<char, 32> word{};
      std::snprintf(word.data(), word.size(), format, as_float32 ? static_cast<double>(static_cast<float>(value)) : value);
      p.add(word.data(), *number_in(word.data()));
    }
    return p.value();
  };
  EXPECT_EQ(precision(true, "%.6f", 0), half_ulp_float32(150));
  EXPECT_EQ(precision(true, "%.17g", 0), half_ulp_float32(150));
  EXPECT_DOUBLE_EQ(precision(false, "%.6f", 0), 0.5e-6);
  EXPECT_DOUBLE_EQ(precision(true, "%.5f", 0), 0.5e-5) << "too few decimals to tell";
  EXPECT_DOUBLE_EQ(precision(false, "%.6f", 0.125), 0.5e-6) << "eighths are exact in any format";
}

TEST(Precision, OfCoordinatesRoundedToDecimals) {
  // A ring of 200 points, rounded to a step and then scaled; as float32.
  const auto ring = [](double step, double radius, double scale = 1) {
    std::vector<Point3> points;
    for (int i = 0; i < 200; ++i) {
      Point3 p(radius * std::cos(0.31 * i), radius * std::sin(0.31 * i), 0.1713 * i);
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<float>(scale * (step > 0 ? std::round(p[axis] / step) * step : p[axis]));
      points.push_back(p);
    }
    return points;
  };
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10)), 0.0005);
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.1, 400)), 0.05);
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10, 2)), 0.001);          // doubled after it was rounded
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10, 1 + 1e-7)), 0.0005);  // moved by a unit in the last place
  EXPECT_EQ(decimal_grid(ring(0.001, 10, 1.00001)), 0);               // by more than the roundings of a float32
  EXPECT_EQ(decimal_grid(ring(0.001, 10, 1.03)), 0);                  // scaled after it was rounded
  EXPECT_EQ(decimal_grid(ring(0, 10)), 0);                            // not rounded
  EXPECT_EQ(decimal_grid(ring(0.1, 10)), 0);                          // as coarse as voxels
  EXPECT_EQ(decimal_grid(ring(0.00001, 100)), 0);                     // as fine as float32
  EXPECT_EQ(decimal_grid(ring(0.5, 4000)), 0);                        // drawn on a grid: the only decimals are 0 and 5
  EXPECT_EQ(decimal_grid(ring(1, 4000)), 0);                          // whole numbers
  EXPECT_EQ(decimal_grid({}), 0);
  EXPECT_EQ(decimal_grid(std::vector<Point3>(100, {1e300, 1, 1})), 0);
}

// Large binary PLY files, whose triangles are read in blocks.

std::string ply_error(const std::string& text) { return error_of(read_ply, text); }

std::string header(const std::string& format, const std::string& vertices, const std::string& faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Appends a number in the byte order.
template <typename T>
void put(std::string& out, std::endian order, T value) {
  const std::string raw = test::raw(value);
  out += order == std::endian::native ? raw : std::string(raw.rbegin(), raw.rend());
}

/// A binary file of `count` triangles in a strip, and a face more with the given corners.
std::string strip_ply(std::endian order, std::uint32_t count, const std::vector<std::int32_t>& last) {
  std::string bytes = header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
                             std::to_string(count + 2), std::to_string(count + 1));
  for (std::uint32_t i = 0; i < count + 2; ++i)
    for (const std::uint32_t c : {i, i % 2, i % 7}) put(bytes, order, 0.5f * static_cast<float>(c));
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes += '\x03';
    for (const std::uint32_t v : {i, i + 1, i + 2}) put(bytes, order, static_cast<std::int32_t>(v));
  }
  bytes += static_cast<char>(last.size());
  for (const std::int32_t v : last) put(bytes, order, v);
  return bytes;
}

TEST(PlyReader, BlocksOfTrianglesAreAsItemsOneByOne) {
  constexpr std::uint32_t kCount = 40'000;  // several blocks
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Result blocks = read_raw(read_ply, strip_ply(order, kCount, {0, 1, 3}));
    // A face of four corners has all read one by one.
    const Result items = read_raw(read_ply, strip_ply(order, kCount, {0, 1, 3, 2}));
    EXPECT_TRUE(blocks.scene.faces.all_triangles());
    EXPECT_FALSE(items.scene.faces.all_triangles());
    EXPECT_EQ(blocks.scene.vertices, items.scene.vertices);
    EXPECT_EQ(blocks.scene.vertices[kCount], Point3(0.5 * kCount, 0, 0.5 * (kCount % 7)));
    EXPECT_EQ(blocks.scene.objects[0].precision, items.scene.objects[0].precision);
    const auto triangles = blocks.scene.faces.corners().first(3 * kCount);
    EXPECT_TRUE(std::ranges::equal(triangles, items.scene.faces.corners().first(3 * kCount)));
    EXPECT_EQ(blocks.scene.faces.corners()[3 * kCount + 2], 3u);
    EXPECT_EQ(blocks.report.faces, kCount + 1);
    EXPECT_EQ(blocks.report.triangles, kCount + 1);
    EXPECT_EQ(items.report.triangles, kCount + 2);
    EXPECT_EQ(blocks.report.vertices, kCount + 2);
    EXPECT_EQ(blocks.scene.materials.size(), items.scene.materials.size());
  }
}

TEST(PlyReader, WhatIsAmissInBlocksIsNamed) {
  constexpr std::uint32_t kCount = 20'000;
  const std::endian order = std::endian::native;
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, -1, 3})),
            "M: face 20000 of 20001: corner of a face is not a vertex index");
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, 1})), "M: face 20000 of 20001: face with 2 corners, needs 3 or more");
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, 1, 20'002})), "M: face 20000 names vertex 20002 of 20002");
  std::string bytes = strip_ply(order, kCount, {0, 1, 3});
  EXPECT_EQ(ply_error(bytes.substr(0, bytes.size() - 1)), "M: the file ends in face 20000 of 20001");
  const float infinite = HUGE_VALF;
  const std::size_t vertices = bytes.find("end_header\n") + 11;
  bytes.replace(vertices + 12 * 17'000 + 4, sizeof(float), reinterpret_cast<const char*>(&infinite), sizeof(float));
  EXPECT_EQ(ply_error(bytes), "M: vertex 17000 of 20002: a coordinate is not finite");
  const std::string lying = header("binary_little_endian", "4000000000", "1");
  EXPECT_EQ(ply_error(lying + std::string(30, '\0')), "M: the file ends in vertex 2 of 4000000000");
}

// Text formats; faults that all formats can have: scripts/faults.txt. Numbers and free-form surfaces of OBJ files.

TEST(ObjReader, NumbersAreRoundedCorrectly) {
  for (const std::string word :
       {"0.1234567890123456", "-149.29088", "123456.789012", "1e-3", "+2.5", "5e-324", "1e-400", ".5", "7."}) {
    const Result r = read_raw(read_obj, "v " + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
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
  EXPECT_EQ(read_raw(read_obj, text + face + "\n").scene.objects[0].precision, half_ulp_float32(150));
}

/// A quarter of a cylinder as a rational patch: its points lie on the circle.
TEST(ObjSurfaces, RationalBSplineIsACylinder) {
  const std::string text =
      "v 1 0 0\nv 1 1 0 0.70710678118654757\nv 0 1 0\nv 1 0 2\nv 1 1 2 0.70710678118654757\nv 0 1 2\n"
      "cstype rat bspline\ndeg 2 1\nsurf 0 1 0 1 1 2 3 -3 -2 -1\nparm u 0 0 0 1 1 1\nparm v 0 0 1 1\nend\n";
  const Result r = read_raw(read_obj, text);
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
}  // namespace ligne
