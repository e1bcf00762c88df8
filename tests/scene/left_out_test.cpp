// Files that people have and that are not quite as the formats say: what can be read is, and what is left out is named in
// one warning.

#include <array>

#include "gltf_builder.hpp"
#include "reader_tools.hpp"

namespace ligne::reader_test {
namespace {

/// Reads a file as the command does.
Result read_file(const std::string& text, std::string_view suffix) {
  Result result;
  const ModelFormat format = detect_format(bytes_of(text), suffix, "M");
  result.scene = read_scene({bytes_of(text), "M"}, format, {}, result.warnings, &result.report);
  return result;
}

std::string refusal(const std::string& text, std::string_view suffix) {
  try {
    read_file(text, suffix);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The lines of a reading's warnings, put together.
std::string warnings_of(const std::string& text, std::string_view suffix) {
  std::string all;
  for (const std::string& line : read_file(text, suffix).warnings.lines()) all += (all.empty() ? "" : " | ") + line;
  return all;
}

const std::string kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kPlyFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kPlyPoints = "0 0 0\n1 0 0\n0 1 0\n";
const std::string kObjSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kStlFacet =
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(LeftOut, EveryReaderNamesWhatItDoesNotKnow) {
  EXPECT_EQ(warnings_of(kObjSquare + "f 1 2 3 4\nwobble 3\nl 1 2\nwobble 4\n", ".obj"),
            "left out: 2 statements 'wobble', 1 lines (l)");
  EXPECT_EQ(
      warnings_of(kPlyHead + kPlyFace + "element wobble 2\nproperty int a\nend_header\n" + kPlyPoints + "3 0 1 2\n7\n8\n",
                  ".ply"),
      "left out: 2 items of element wobble");
  const std::string remark = "Wobble made this\n", head = kPlyHead + kPlyFace + "end_header\n" + kPlyPoints + "3 0 1 2\n";
  EXPECT_EQ(warnings_of(std::string(head).insert(head.find("element"), remark), ".ply"),
            "left out: 1 header lines 'Wobble'");
  EXPECT_EQ(warnings_of("solid a\n" + kStlFacet + "wobble 1 2\n" + kStlFacet + "endsolid a\n", ".stl"),
            "left out: 1 statements 'wobble'");
  EXPECT_EQ(warnings_of("Named object: \"a\"\nTri-mesh, Vertices: 3 Faces: 1\nVertex list:\nVertex 0: X:0 Y:0 Z:0\n"
                        "Vertex 1: X:1 Y:0 Z:0\nVertex 2: X:0 Y:1 Z:0\nFace list:\nFace 0: A:0 B:1 C:2\nWobble: 3\n",
                        ".asc"),
            "left out: 1 lines 'Wobble'");
  gltf_test::Builder b = gltf_test::square();
  b.root["extensionsUsed"] = {"EXT_wobble"};
  b.root["extensions"]["EXT_wobble"]["things"] = gltf_test::json::array();
  b.root["nodes"][0]["extensions"]["EXT_wobble"] = {{"thing", 0}};
  b.root["meshes"][0]["primitives"][0]["extensions"]["EXT_wobble"] = gltf_test::json::object();
  b.root["materials"] = {{{"extensions", {{"KHR_materials_sheen", gltf_test::json::object()}}}}};
  // Numbers of features and what a pointer may choose change no line.
  b.root["meshes"][0]["primitives"][0]["extensions"]["EXT_mesh_features"] = gltf_test::json::object();
  b.root["nodes"][0]["extensions"]["EXT_instance_features"] = gltf_test::json::object();
  b.root["nodes"][0]["extensions"]["KHR_node_selectability"] = {{"selectable", false}};
  EXPECT_EQ(warnings_of(b.text(), ".gltf"), "left out: 1 nodes with EXT_wobble, 1 primitives with EXT_wobble");
}

TEST(LeftOut, TexturesOfGltfAreCountedOnce) {
  gltf_test::Builder b = gltf_test::square();
  const gltf_test::json textured{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}};
  b.root["materials"] = {textured, textured};
  EXPECT_EQ(warnings_of(b.text(), ".gltf"), "left out: 1 textures");
}

TEST(LeftOut, PlyStripsOfTriangles) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const Result r = read_file(head + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 1\n2 1 1\n8 0 1 2 3 -1 1 4 3\n", ".ply");
  const auto corners = r.scene.faces.corners();
  EXPECT_EQ(std::vector<std::uint32_t>(corners.begin(), corners.end()),
            (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 1, 4, 3}));
  EXPECT_TRUE(r.warnings.lines().empty());
  // Strips joined by corners twice, in the old way.
  EXPECT_EQ(read_file(head + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 1\n2 1 1\n6 0 1 2 2 3 4\n", ".ply").scene.faces.size(), 2u);
}

TEST(LeftOut, PlyHeaderOfWhichOneLineEndsInCarriageReturn) {
  EXPECT_EQ(read_file(kPlyHead + kPlyFace + "end_header\r\n" + kPlyPoints + "3 0 1 2\n", ".ply").scene.faces.size(), 1u);
}

TEST(LeftOut, PlyValuesThatTheHeaderDoesNotName) {
  EXPECT_EQ(warnings_of(kPlyHead + kPlyFace + "property list uchar float texcoord\nend_header\n" + kPlyPoints +
                            "3 0 1 2 6 0 0 1 0 0 1 9 1 1 1 1 1 1 1 1 1\n",
                        ".ply"),
            "left out: 10 values at ends of lines");
}

TEST(LeftOut, StlThatEndsInTwoWords) {
  EXPECT_EQ(read_file("solid cube\n" + kStlFacet + "end solid cube\n", ".stl").scene.objects[0].name, "cube");
  EXPECT_EQ(refusal("solid cube\n" + kStlFacet + "end cube\n", ".stl"), "M:9: expected 'solid' after 'end', found 'cube'");
}

TEST(LeftOut, TrianglesThatAreLinesAreNoDrawing) {
  const std::string line = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 0\nendloop\nendfacet\n";
  EXPECT_EQ(refusal("solid l\n" + line + "endsolid l\n", ".stl"),
            "M: none of its 1 faces has an area: they are lines or points");
  EXPECT_EQ(read_file("solid l\n" + line + kStlFacet + "endsolid l\n", ".stl").scene.faces.size(), 1u);
}

TEST(LeftOut, ObjNamesThatEndInABackslash) {
  const Result r = read_file(kObjSquare + "g x \\\ny\nusemtl a\\b\\\nf 1 2 3 4\n# C:\\models\\\nf 1 2 \\\n3\n", ".obj");
  EXPECT_EQ(r.scene.faces.size(), 2u);
  EXPECT_EQ(r.scene.materials.at(0).name, "a\\b\\");
  EXPECT_EQ(r.warnings.lines(), std::vector<std::string>{"1 names that end in a backslash kept as they are"});
}

TEST(LeftOut, FilesOfOtherThingsAreNamed) {
  EXPECT_EQ(refusal("{\"asset\":{\"version\":\"1.0\"},\"scenes\":{},\"meshes\":{}}", ".gltf"),
            "M: is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb");
  EXPECT_EQ(refusal("{\"asset\":{},\"meshes\":{\"m\":{}}}", ".gltf"),
            "M: is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb");
  EXPECT_EQ(refusal(std::string("glTF\1\0\0\0\x20\0\0\0\0\0\0\0\0\0\0\0............", 32), ".glb"),
            "M: is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb");
  EXPECT_EQ(refusal(kPlyHead + "element edge 1\nproperty int vertex1\nend_header\n" + kPlyPoints + "0\n", ".ply"),
            "M: holds no faces; left out: 1 items of element edge");
}

}  // namespace
}  // namespace ligne::reader_test
