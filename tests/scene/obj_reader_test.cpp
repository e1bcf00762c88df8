#include "scene/readers/obj/obj_reader.hpp"

#include "reader_tools.hpp"

namespace ligne {
namespace {

/// Without shading.
Scene plain_obj(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_obj({bytes, name}, report, warnings);
}

using namespace reader_test;

std::string obj_error(const std::string& text) { return error_of(plain_obj, text); }

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::uint32_t> contour(const Scene& scene, std::size_t f) {
  const auto c = scene.faces.contour(f, 0);
  return {c.begin(), c.end()};
}

TEST(ObjReader, PolygonsKeepTheirCorners) {
  const Result r = read_raw(plain_obj, kSquare + "v 0.5 2 0\nf 1 2 3 5 4\nf 1 2 3\n");
  expect_sound(r.scene);
  ASSERT_EQ(r.scene.faces.size(), 2u);
  EXPECT_EQ(contour(r.scene, 0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(r.scene.vertices[3], Point3(0.5, 2, 0));
  EXPECT_EQ(r.report.faces, 2u);
  EXPECT_EQ(r.report.triangles, 4u);
  EXPECT_EQ(r.report.vertices, 5u);
  EXPECT_EQ(r.scene.up_axis, Axis::y);
}

TEST(ObjReader, EveryFormOfCorner) {
  const std::string head = kSquare + "vt 0 0\nvn 0 0 1\n";
  for (const char* face :
       {"f 1 2 3 4", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/1/1 3/1/1 4/1/1", "f 1// 2// 3// 4//",
        "f -4 -3 -2 -1", "f -4/-1 -3/-1 -2/-1 -1/-1", "f\t1\t2\t3\t4 # a comment", "  f 1 2 3 4  "}) {
    const Result r = read_raw(plain_obj, head + face + "\n");
    ASSERT_EQ(r.scene.faces.size(), 1u) << face;
    EXPECT_EQ(contour(r.scene, 0), (std::vector<std::uint32_t>{0, 1, 2, 3})) << face;
  }
}

TEST(ObjReader, RelativeIndicesCountFromTheVerticesSoFar) {
  const Result r = read_raw(plain_obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 9 9 9\nf -2 -1 1\n");
  EXPECT_EQ(r.scene.vertices[contour(r.scene, 1)[0]], Point3(1, 1, 0));
  EXPECT_EQ(r.scene.vertices[contour(r.scene, 1)[1]], Point3(9, 9, 9));
}

TEST(ObjReader, LineEndsByteOrderMarkAndContinuedLines) {
  const std::string text =
      "\xEF\xBB\xBF\r\n\r\n# made by hand\r\nv 0 0 \\\r\n0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 \\\r\n 2\\\r\n 3\r\n";
  const Result r = read_raw(plain_obj, text);
  EXPECT_EQ(contour(r.scene, 0), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ObjReader, VertexWithWeightAndColour) {
  const Result r = read_raw(plain_obj, "v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv 7 8 10 1 0.1 0.2 0.3 0.4\nf 1 2 3\n");
  EXPECT_EQ(r.scene.vertices[1], Point3(4, 5, 6));
}

TEST(ObjReader, ObjectsOwnTheirVerticesAndGroupsDoNot) {
  const std::string text = kSquare + "o one\ng a\nf 1 2 3\ng b\nf 1 3 4\no empty\no two\nf 4 3 2\n";
  const Result r = read_raw(plain_obj, text);
  expect_sound(r.scene);
  ASSERT_EQ(r.scene.objects.size(), 2u);
  EXPECT_EQ(r.scene.objects[0].name, "one");
  EXPECT_EQ(r.scene.objects[0].face_end, 2u);
  EXPECT_EQ(r.scene.objects[0].vertex_end, 4u);
  EXPECT_EQ(r.scene.objects[1].name, "two");
  EXPECT_EQ(r.scene.vertices.size(), 7u);
  EXPECT_EQ(read_raw(plain_obj, kSquare + "g a\nf 1 2 3\ng b\nf 1 3 4\n").scene.objects.size(), 1u);
}

TEST(ObjReader, MaterialsByNameWithoutTheirLibrary) {
  const Result r =
      read_raw(plain_obj, "mtllib missing.mtl\n" + kSquare +
                              "f 1 2 3\nusemtl red paint\nf 1 3 4\nusemtl b\nf 2 3 4\nusemtl\tred paint\nf 1 2 4\n");
  ASSERT_EQ(r.scene.materials.size(), 3u);
  EXPECT_EQ(r.scene.materials[0].name, "red paint");
  EXPECT_EQ(r.scene.materials[1].name, "b");
  EXPECT_EQ(r.scene.face_material, (std::vector<std::uint32_t>{2, 0, 1, 0}));
}

TEST(ObjReader, NumbersAreRoundedCorrectly) {
  for (const std::string word :
       {"0.1234567890123456", "-149.29088", "123456.789012", "1e-3", "+2.5", "5e-324", "1e-400", ".5", "7."}) {
    const Result r = read_raw(plain_obj, "v " + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(r.scene.vertices[0].x, std::strtod(word.c_str(), nullptr)) << word;
  }
}

TEST(ObjReader, LinesAndCurvesAreLeftOutAndCounted) {
  const Result r = read_raw(plain_obj, kSquare + "l 1 2\np 1\nf 1 2 3\ncurv 0 1 1 2 3\n");
  EXPECT_EQ(r.warnings.left_out().text(), "left out: 1 lines (l), 1 points (p), 1 curves (curv)");
  EXPECT_EQ(obj_error(kSquare + "l 1 2\np 1\nl 2 3\n"), "M: holds no faces; left out: 2 lines (l), 1 points (p)");
}

TEST(ObjReader, ErrorsNameTheLine) {
  EXPECT_EQ(obj_error(kSquare + "f 1 2\n"), "M:5: face with 2 corners, needs 3 or more");
  EXPECT_EQ(obj_error(kSquare + "f\n"), "M:5: face with 0 corners, needs 3 or more");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 5\n"), "M:5: face names vertex 5 of 4");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 -5\n"), "M:5: face names vertex -5 of 4");
  EXPECT_EQ(obj_error(kSquare + "f 0 1 2\n"), "M:5: face names vertex 0 of 4");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 three\n"), "M:5: 'three' is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 3.5\n"), "M:5: '3.5' is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 3/1/1/1\n"), "M:5: '3/1/1/1' is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 /3\n"), "M:5: '/3' is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 99999999999\n"),
            "M:5: '99999999999' is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 2147483647\n"), "M:5: face names vertex 2147483647 of 4");
  EXPECT_EQ(obj_error("v 0 0\n"), "M:1: vertex with 2 coordinates, needs 3");
  EXPECT_EQ(obj_error("v 0 0 0\nv 0 zero 0\n"), "M:2: 'zero' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 nan 0\n"), "M:1: 'nan' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 inf 0\n"), "M:1: 'inf' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 1e999 0\n"), "M:1: '1e999' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 1,5 0\n"), "M:1: '1,5' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 0x10 0\n"), "M:1: '0x10' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 1 2 3 4 5 6 7 8 9\n"), "M:1: vertex with more than 8 numbers");
  EXPECT_EQ(obj_error("\r\nv 0 0 0\r\n\r\nf 1 \\\r\n2\r\n"), "M:4: face with 2 corners, needs 3 or more");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 3 \\"), "M:5: the file ends in a continued line");
  EXPECT_EQ(obj_error(kSquare), "M: holds no faces");
  EXPECT_EQ(obj_error(kSquare + std::string("f 1 2\0 3\n", 10)), "M:5: zero byte in a text file");
  EXPECT_EQ(obj_error("v 0 0 " + std::string(100, 'x')),
            "M:1: '" + std::string(40, 'x') + "...' is not a coordinate of a vertex");
  EXPECT_EQ(obj_error("v 0 0 \x1b[2J"), "M:1: '\\x1b[2J' is not a coordinate of a vertex");
}

// The first error is the one that is told, and what follows is not read.
TEST(ObjReader, StopsAtTheFirstError) {
  EXPECT_EQ(obj_error("v a 0 0\nf 1 2\n"), "M:1: 'a' is not a coordinate of a vertex");
}

struct Model {
  const char* file;
  std::size_t faces, triangles, vertices;
  Point3 min, max;
};

TEST(ObjReader, ModelsOfOthers) {
  LIGNE_NEED_MODELS(folder);
  const Model models[] = {
      {"teapot.obj", 6320, 6320, 3644, {-3, 0, -2}, {3.434, 3.15, 2}},
      {"stanford-bunny.obj", 69451, 69451, 35947, {-0.0947, 0.033, -0.0619}, {0.061, 0.1873, 0.0588}},
      {"beetle.obj", 2053, 2053, 1148, {-0.2167, 0.3061, -0.2538}, {0.1435, 0.609, 0.6378}},
      {"spider.obj", 1368, 1368, 762, {-92.6552, -42.2338, -106.6912}, {57.9362, 37.504, 86.6912}},
      {"quadknot.obj", 1440, 2880, 1440, {-149.2909, -66.859, -167.229}, {21.4438, 66.8602, 14.0946}},
      {"cornell_box.obj", 18, 36, 76, {0, 0, 0}, {556, 548.8, 559.2}},
      {"negative_indices.obj", 6, 12, 8, {-1, -1, -1}, {1, 1, 1}},
      {"polygonfaces.obj", 1, 3, 5, {-500, 0, -500}, {500, 500, 500}},
  };
  for (const Model& model : models) {
    SCOPED_TRACE(model.file);
    Warnings warnings;
    ReadReport report;
    const Scene scene = read_scene(folder / model.file, {}, warnings, &report);
    expect_sound(scene);
    EXPECT_EQ(report.format, ModelFormat::obj);
    EXPECT_EQ(report.faces, model.faces);
    EXPECT_EQ(report.triangles, model.triangles);
    EXPECT_EQ(report.vertices, model.vertices);
    expect_bounds(scene, model.min, model.max);
  }
  Warnings warnings;
  // Nine `o` lines, but the only face of front_wall is commented out.
  EXPECT_EQ(read_scene(folder / "cornell_box.obj", {}, warnings).objects.size(), 8u);
  EXPECT_EQ(read_scene(folder / "spider.obj", {}, warnings).objects.size(), 1u);
}

}  // namespace
}  // namespace ligne
