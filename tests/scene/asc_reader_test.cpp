#include "scene/readers/studio/asc_reader.hpp"

#include "reader_tools.hpp"

namespace ligne {
namespace {

/// Without shading.
Scene plain_asc(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_asc(bytes, name, report, warnings);
}

using namespace reader_test;

std::string asc_error(const std::string& text) { return error_of(plain_asc, text); }

const std::string kHead = "Named object: \"Box\"\nTri-mesh, Vertices: 3     Faces: 1\nVertex list:\n";
const std::string kVertices =
    "Vertex 0:  X: 0     Y: -0     Z: 1.5\nVertex 1:  X:1.0 Y:0 Z:0\nVertex 2:\tX:\t0\tY:1\tZ:0   U:0 V:1\n";
const std::string kFace = "Face list:\nFace 0:    A:0 B:1 C:2 AB:1 BC:0 CA:1\n";

TEST(AscReader, FlagsOfTheEdges) {
  const Result r = read_raw(plain_asc, kHead + kVertices + kFace + "Material:\"GREY \"STONE\"\"\nSmoothing: 1, 2\n");
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.corner_flags, (std::vector<std::uint8_t>{0, kCornerFileHidden, 0}));
  EXPECT_EQ(r.scene.vertices[0], Point3(0, 0, 1.5));
  EXPECT_EQ(r.scene.vertices[2], Point3(0, 1, 0));
  EXPECT_EQ(r.scene.objects[0].name, "Box");
  EXPECT_EQ(r.scene.materials[0].name, "GREY \"STONE\"");
  EXPECT_EQ(r.scene.up_axis, Axis::z);
  EXPECT_EQ(r.report.triangles, 1u);
  EXPECT_EQ(r.report.vertices, 3u);
  EXPECT_TRUE(r.warnings.counts().empty());
}

TEST(AscReader, EdgesWithoutFlagsAreDrawn) {
  EXPECT_TRUE(read_raw(plain_asc, kHead + kVertices + "Face list:\nFace 0: A:0 B:1 C:2\n").scene.corner_flags.empty());
}

TEST(AscReader, LightsPagesCamerasAndLineEnds) {
  std::string text =
      "Ambient light color: Red=0.3 Green=0.3 Blue=0.3\n\n" + kHead + "\n     Page 1\n\n" + kVertices + kFace +
      "Named object: \"Lamp\"\nDirect light\nPosition:  X:-25.5 Y:3 Z:2450\nLight color: Red=1 Green=1 Blue=1\n"
      "Named object: \"Cam\"\nCamera (50.000004mm)\nPosition:  X:1 Y:2 Z:3\nTarget:  X:0 Y:0 Z:0\nBank angle: 0 degrees\n" +
      kHead + kVertices + kFace;
  for (const bool crlf : {false, true}) {
    if (crlf) {
      for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + 2)) text.replace(i, 1, "\r\n");
    }
    const Result r = read_raw(plain_asc, text);
    EXPECT_EQ(r.scene.objects.size(), 2u);
    ASSERT_EQ(r.scene.lights.size(), 1u);
    EXPECT_EQ(r.scene.lights[0].kind, Light::Kind::point);
    EXPECT_EQ(r.scene.lights[0].vector, Point3(-25.5, 3, 2450));
    EXPECT_TRUE(r.warnings.counts().empty());
  }
}

TEST(AscReader, LightsAndCamerasEndAMeshWithoutAnObjectLine) {
  const std::string camera = "Camera (50mm)\nPosition: X:1 Y:2 Z:3\n", light = "Direct light\nPosition: X:1 Y:2 Z:3\n";
  const Result r = read_raw(plain_asc, kHead + kVertices + kFace + camera + kHead + kVertices + kFace + light);
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.objects.size(), 2u);
  EXPECT_EQ(asc_error(kHead + kVertices + camera), "M:7: mesh 'Box' ends with 3 of 3 vertices and 0 of 1 faces");
}

TEST(AscReader, UnknownLinesAreCounted) {
  const Result r = read_raw(plain_asc, kHead + kVertices + kFace + "Something: else\n");
  EXPECT_EQ(r.warnings.left_out().text(), "left out: 1 lines 'Something'");
}

TEST(AscReader, ErrorsNameTheLine) {
  EXPECT_EQ(asc_error(kHead + "Vertex 0: X: 0 Y: zero Z: 0\n"), "M:4: 'zero' is not a coordinate");
  EXPECT_EQ(asc_error(kHead + "Vertex 0: X: 0 Z: 0\n"), "M:4: expected 'Y:', found 'Z: 0'");
  EXPECT_EQ(asc_error(kHead + "Vertex 1: X: 0 Y: 0 Z: 0\n"), "M:4: expected vertex 0, found '1'");
  EXPECT_EQ(asc_error(kHead + kVertices + "Vertex 3: X: 0 Y: 0 Z: 0\n"), "M:7: vertex 3 of a mesh with 3");
  EXPECT_EQ(asc_error(kHead + kVertices + "Face 0: A:0 B:1 C:3 AB:1 BC:1 CA:1\n"), "M:7: face names vertex 3 of 3");
  EXPECT_EQ(asc_error(kHead + kVertices + "Face 0: A:0 B:-1 C:2 AB:1 BC:1 CA:1\n"),
            "M:7: '-1' after 'B:' is not a whole number in range");
  EXPECT_EQ(asc_error(kHead + kVertices + "Face 0: A:0 B:1\n"), "M:7: expected 'C:', found ''");
  EXPECT_EQ(asc_error(kHead + kVertices + "Face 0: A:0 B:1 C:2 AB:1\n"), "M:7: expected 'BC:', found ''");
  EXPECT_EQ(asc_error(kHead + kVertices + kFace + "Face 1: A:0 B:1 C:2\n"), "M:9: face 1 of a mesh with 1");
  EXPECT_EQ(asc_error(kHead + kVertices), "M:6: mesh 'Box' ends with 3 of 3 vertices and 0 of 1 faces");
  EXPECT_EQ(asc_error(kHead + "Vertex 0: X:0 Y:0 Z:0\n\nNamed object: \"b\"\n"),
            "M:6: mesh 'Box' ends with 1 of 3 vertices and 0 of 1 faces");
  EXPECT_EQ(asc_error("Named object: \"a\"\nTri-mesh, Vertices: 4294967295 Faces: 1\n"),
            "M:2: '4294967295' after 'Vertices:' is not a whole number in range");
  EXPECT_EQ(asc_error("Named object: \"a\"\nTri-mesh, Vertices: 4000000000 Faces: 4000000000\n"),
            "M:2: mesh 'a' ends with 0 of 4000000000 vertices and 0 of 4000000000 faces");
  EXPECT_EQ(asc_error("Named object: \"a\"\nTri-mesh\n"), "M:2: expected 'Vertices:', found ''");
  EXPECT_EQ(asc_error("Named object: \"a\"\nVertex 0: X:0 Y:0 Z:0\n"), "M:2: mesh data outside a tri-mesh");
  EXPECT_EQ(asc_error(kHead + "Material:\"a\"\n"), "M:4: material before the first face");
  EXPECT_EQ(asc_error("Position: X:0 Y:0 Z:0\n"), "M:1: position outside a light or camera");
  EXPECT_EQ(asc_error("Ambient light color: Red=1\n"), "M: holds no faces");
}

TEST(AscReader, ModelsOfOthers) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  ReadReport report;
  const Scene city = read_scene(folder / "CITY.ASC", {}, warnings, &report);
  expect_sound(city);
  EXPECT_EQ(report.format, ModelFormat::asc_3d_studio);
  EXPECT_EQ(report.triangles, 796u);
  EXPECT_EQ(report.vertices, 610u);
  EXPECT_EQ(city.objects.size(), 25u);
  EXPECT_EQ(city.lights.size(), 1u);
  EXPECT_EQ(std::count(city.corner_flags.begin(), city.corner_flags.end(), kCornerFileHidden), 800);
  expect_bounds(city, {-3000, -5050, 0}, {4200, 300, 1433.3823});
  EXPECT_TRUE(warnings.counts().empty());

  const Scene small = read_scene(folder / "TESTI.ASC", {}, warnings, &report);
  expect_sound(small);
  EXPECT_EQ(report.triangles, 9u);
  EXPECT_EQ(report.vertices, 13u);
  EXPECT_EQ(small.objects.size(), 3u);
  EXPECT_EQ(std::count(small.corner_flags.begin(), small.corner_flags.end(), kCornerFileHidden), 7);
  expect_bounds(small, {-254.0217, -287.5513, -177.3574}, {198.6403, 0, 196.2755});
}

}  // namespace
}  // namespace ligne
