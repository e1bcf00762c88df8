#include "scene/readers/stl_reader.hpp"

#include <cmath>
#include <cstring>

#include "reader_tools.hpp"

namespace ligne {
namespace {

using namespace reader_test;

std::string stl_error(const std::string& text) { return error_of(read_stl_ascii, text); }

const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

std::string binary(const std::string& header, std::uint32_t claimed, const std::vector<float>& coordinates) {
  std::string out = header + std::string(80 - header.size(), '\0');
  const auto append = [&](const auto& value) { out.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  append(claimed);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0) out.append(12, '\0');
    append(coordinates[i]);
    if (i % 9 == 8) out.append(2, '\0');
  }
  return out;
}

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST(StlReader, OneObjectPerSolid) {
  const Result r = read_raw(read_stl_ascii,
                            "solid first part\n" + kFacet + kFacet + "endsolid first part\nsolid\n" + kFacet + "endsolid");
  expect_sound(r.scene);
  ASSERT_EQ(r.scene.objects.size(), 2u);
  EXPECT_EQ(r.scene.objects[0].name, "first part");
  EXPECT_EQ(r.scene.objects[0].face_end, 2u);
  EXPECT_EQ(r.report.triangles, 3u);
  EXPECT_EQ(r.report.vertices, 9u);
  EXPECT_EQ(r.scene.up_axis, Axis::z);
}

TEST(StlReader, CaseLineEndsAndNormalsDoNotMatter) {
  const std::string text =
      "\xEF\xBB\xBF\r\nSOLID X\r\nFACET NORMAL nan -nan 0\r\nOUTER LOOP VERTEX 0 0 0 VERTEX 1E0 0 0\r\nVERTEX 0 1 0 "
      "ENDLOOP\r\nENDFACET\r\n"
      "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\nENDSOLID X\r\n\r\n";
  EXPECT_EQ(read_raw(read_stl_ascii, text).scene.faces.size(), 2u);
}

TEST(StlReader, TextErrorsNameTheLine) {
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n"),
            "M:5: 'x' is not a coordinate of a vertex");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n"),
            "M:4: 'nan' is not a coordinate of a vertex");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0"), "M:4: the file ends in a vertex");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0"), "M:2: the file ends in a facet");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1 1 outer loop"), "M:2: expected 'outer loop' in a facet, found '1'");
  EXPECT_EQ(stl_error("solid a\n" + kFacet), "M:8: the file ends in a solid; expected 'facet' or 'endsolid'");
  EXPECT_EQ(stl_error("solid a\nsolid b\n"), "M:2: expected 'facet' or 'endsolid', found 'solid'");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
            "M:6: expected 'vertex' in a facet, found 'endloop'");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"),
            "M:7: expected 'endloop' after the three vertices of a facet, found 'vertex'");
  EXPECT_EQ(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop"),
            "M:7: the file ends after a facet's loop; expected 'endfacet'");
  EXPECT_EQ(stl_error("solid a\nendsolid a\n"), "M: holds no faces");
  EXPECT_EQ(stl_error("solid a\nendsolid a\nfacet"), "M:3: expected 'solid', found 'facet'");
}

TEST(StlReader, BinaryEvenWithAHeaderThatBeginsWithSolid) {
  const std::string bytes = binary("solid made by a careless exporter", 1, kTriangle);
  EXPECT_EQ(detect_format(bytes_of(bytes), ".stl", "M"), ModelFormat::stl_binary);
  const Result r = read_raw(read_stl_binary, bytes);
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.vertices[1], Point3(1, 0, 0));
  EXPECT_EQ(r.scene.objects[0].precision, std::ldexp(1.0, -24));
  EXPECT_EQ(r.report.vertices, 3u);
}

TEST(StlReader, BinaryCountsThatLie) {
  const std::string one = binary("", 2, kTriangle);
  EXPECT_EQ(error_of(read_stl_binary, one),
            "M: binary STL declares 2 triangles, which need 184 bytes, but the file has 134");
  EXPECT_EQ(error_of(read_stl_binary, binary("", 4294967295u, kTriangle)),
            "M: binary STL declares 4294967295 triangles, which need 214748364834 bytes, but the file has 134");
  EXPECT_EQ(error_of(read_stl_binary, binary("", 0, kTriangle)),
            "M: binary STL declares 0 triangles, which need 84 bytes, but the file has 134");
  EXPECT_EQ(error_of(read_stl_binary, std::string(50, '\0')), "M: binary STL of 50 bytes, shorter than its header of 84");
  EXPECT_EQ(error_of(read_stl_binary, binary("", 0, {})), "M: holds no faces");
}

TEST(StlReader, BinaryCoordinatesThatAreNotFiniteAreErrors) {
  std::vector<float> two = kTriangle;
  two.insert(two.end(), {0, 0, 0, NAN, 0, 0, 0, INFINITY, 0});
  EXPECT_EQ(error_of(read_stl_binary, binary("", 2, two)), "M: triangle 1 of 2: a coordinate is not finite");
}

TEST(StlReader, ModelsOfOthers) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  ReadReport report;
  const Scene part = read_scene(folder / "featuretype.stl", {}, warnings, &report);
  EXPECT_EQ(report.format, ModelFormat::stl_binary);
  EXPECT_EQ(report.triangles, 3476u);
  EXPECT_EQ(report.vertices, 10428u);
  expect_sound(part);
  expect_bounds(part, {-2.5, -1.25, 0}, {2.5, 1.25, 1.375});
  const Scene tray = read_scene(folder / "1002_tray_bottom.stl", {}, warnings, &report);
  EXPECT_EQ(report.format, ModelFormat::stl_ascii);
  EXPECT_EQ(report.triangles, 4520u);
  EXPECT_EQ(report.vertices, 13560u);
  expect_sound(tray);
  expect_bounds(tray, {0, 0, -355.6}, {355.6, 3.175, 0});
  EXPECT_EQ(tray.objects.at(0).name, "1002_tray_bottom");
  EXPECT_DOUBLE_EQ(tray.objects[0].precision, 0.5e-4);  // 3.556000e+002
}

}  // namespace
}  // namespace ligne
