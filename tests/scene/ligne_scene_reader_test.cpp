#include "scene/readers/ligne_scene_reader.hpp"

#include <cmath>

#include "reader_tools.hpp"

namespace ligne {
namespace {

using namespace reader_test;

std::string scene_error(const std::string& text) { return error_of(read_ligne_scene, text); }

const std::string kSceneHead = R"({"format": "ligne-scene", "version": 1, )";
const std::string kSceneVertices = R"("vertices": [[0,0,0],[4,0,0],[4,4,0],[0,4,0],[1,1,0],[2,1,0],[2,2,0]])";

std::string with_faces(const std::string& faces) {
  return kSceneHead + "\"objects\": [{" + kSceneVertices + ", \"faces\": [" + faces + "]}]}";
}
std::string with_face(const std::string& face) { return with_faces("{" + face + "}"); }

TEST(LigneSceneReader, EverythingThatItHolds) {
  const Result r = read_raw(read_ligne_scene, kSceneHead + R"("up": "y",
    "materials": [{"name": "red", "color": [1, 0, 0.5]}, {"opacity": 0.25}],
    "objects": [{"name": "plate", )" + kSceneVertices +
                                                  R"(, "precision": 0.01, "faces": [
        {"outer": [0,1,2,3], "holes": [[4,6,5]], "material": 1,
         "details": [{"material": 0, "contour": [[3,3,0],[3.5,3,0],[3.5,3.5,0],[3,3.5,0]]}]},
        {"outer": [0,1,2]}]}],
    "lights": [{"kind": "parallel", "direction": [0,0,-1]}, {"kind": "point", "position": [1,2,3]}]})");
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.up_axis, Axis::y);
  EXPECT_EQ(r.scene.objects[0].name, "plate");
  EXPECT_EQ(r.scene.objects[0].precision, 0.01);
  EXPECT_EQ(r.scene.faces.contour_count(0), 2u);
  EXPECT_EQ(r.scene.faces.contour(0, 1)[1], 6u);
  EXPECT_EQ(r.scene.face_material, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(r.scene.materials[0].color, Point3(1, 0, 0.5));
  EXPECT_EQ(r.scene.materials[1].opacity, 0.25);
  ASSERT_EQ(r.scene.details.size(), 1u);
  EXPECT_EQ(r.scene.details[0].contour[1], Point3(3.5, 3, 0));
  EXPECT_EQ(r.scene.lights[0].kind, Light::Kind::parallel);
  EXPECT_EQ(r.scene.lights[1].vector, Point3(1, 2, 3));
  EXPECT_EQ(r.report.triangles, 7u + 1);
}

TEST(LigneSceneReader, IndicesAreThoseOfTheObject) {
  const std::string object = "{" + kSceneVertices + R"(, "faces": [{"outer": [0,1,2]}]})";
  const Result r = read_raw(read_ligne_scene, kSceneHead + "\"objects\": [" + object + "," + object + "]}");
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.faces.contour(1, 0)[0], 7u);
  EXPECT_EQ(r.scene.objects[0].precision, std::ldexp(1.0, 2 - 53));
}

TEST(LigneSceneReader, AboutIsForPeople) {
  const std::string objects = "\"objects\": [{" + kSceneVertices + R"(, "faces": [{"outer": [0,1,2]}]}]})";
  const Result r = read_raw(read_ligne_scene, kSceneHead + R"("about": "a triangle", )" + objects);
  EXPECT_EQ(r.scene.faces.size(), 1u);
  EXPECT_TRUE(r.warnings.counts().empty());
  EXPECT_EQ(scene_error(kSceneHead + R"("about": ["a triangle"], )" + objects), "M: about: is not a string");
}

TEST(LigneSceneReader, ErrorsNameThePlace) {
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,99,2])")), "M: objects[0].faces[0].outer[1]: vertex 99 of 7");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,-1,2])")), "M: objects[0].faces[0].outer[1]: vertex -1 of 7");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,1.0,2])")), "M: objects[0].faces[0].outer[1]: is not a whole number");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,1])")),
            "M: objects[0].faces[0].outer: contour with 2 corners, needs 3 or more");
  EXPECT_EQ(scene_error(with_face(R"("outer": 5)")), "M: objects[0].faces[0].outer: is not an array");
  EXPECT_EQ(scene_error(with_face(R"("material": 0)")), "M: objects[0].faces[0].material: material 0 of 0");
  EXPECT_EQ(scene_error(with_face(R"("holes": [])")), "M: objects[0].faces[0]: key 'outer' is missing");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,1,2], "holes": [[4,5,77]])")),
            "M: objects[0].faces[0].holes[0][2]: vertex 77 of 7");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,1,2], "hole": [])")), "M: objects[0].faces[0]: unknown key 'hole'");
  EXPECT_EQ(scene_error(with_face(R"("outer": [0,1,2], "details": [{"contour": []}])")),
            "M: objects[0].faces[0].details[0]: key 'material' is missing");
  EXPECT_EQ(scene_error(with_faces("7")), "M: objects[0].faces[0]: is not an object");
  EXPECT_EQ(scene_error(with_faces("")), "M: holds no faces");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [{"vertices": [[0,0]], "faces": []}]})"),
            "M: objects[0].vertices[0]: is not an array of three numbers");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [{"vertices": [[0,0,"a"]], "faces": []}]})"),
            "M: objects[0].vertices[0][2]: is not a number");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [{"vertices": [[0,0,null]], "faces": []}]})"),
            "M: objects[0].vertices[0][2]: is not a number");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [{"vertices": [], "faces": [], "precision": -1}]})"),
            "M: objects[0].precision: is negative");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": {}})"), "M: objects: is not an array");
  EXPECT_EQ(scene_error(kSceneHead + R"("up": "w", "objects": []})"), "M: up: 'w' is not 'x', 'y' or 'z'");
  EXPECT_EQ(scene_error(kSceneHead + R"("materials": [{"color": [0,2,0]}], "objects": []})"),
            "M: materials[0].color[1]: is not in 0 .. 1");
  EXPECT_EQ(scene_error(kSceneHead + R"("materials": [{"opacity": -0.5}], "objects": []})"),
            "M: materials[0].opacity: is not in 0 .. 1");
  EXPECT_EQ(scene_error(kSceneHead + R"("lights": [{"kind": "spot"}], "objects": []})"),
            "M: lights[0].kind: 'spot' is not 'parallel' or 'point'");
  EXPECT_EQ(scene_error(kSceneHead + R"("lights": [{"kind": "point", "direction": [0,0,1]}], "objects": []})"),
            "M: lights[0].direction: does not belong to a light of kind 'point'");
  EXPECT_EQ(scene_error(kSceneHead + R"("lights": [{"kind": "parallel", "direction": [0,0,0]}], "objects": []})"),
            "M: lights[0].direction: is not a direction (zero length)");
  EXPECT_EQ(scene_error(R"({"format": "ligne-drawing"})"), "M: format: 'ligne-drawing' is not 'ligne-scene'");
  EXPECT_EQ(scene_error(R"({"format": "ligne-scene", "version": 2, "objects": []})"), "M: version: only version 1 is known");
  EXPECT_EQ(scene_error(R"({"format": "ligne-scene", "objects": []})"), "M: key 'version' is missing");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [], "extras": 1})"), "M: unknown key 'extras'");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [], "objects": []})"), "M: key 'objects' twice in one JSON object");
  EXPECT_EQ(scene_error("[]"), "M: is not an object");
}

TEST(LigneSceneReader, BrokenJson) {
  EXPECT_EQ(scene_error("{\n\"format\": \n}").substr(0, 20), "M:3: not valid JSON:");
  EXPECT_EQ(scene_error("{\"format\": \"ligne-scene\"").substr(0, 20), "M:1: not valid JSON:");
  EXPECT_EQ(scene_error(kSceneHead + R"("objects": [{"vertices": [[0,0,1e999]], "faces": []}]})"),
            "M:1: a number is out of range");
  EXPECT_EQ(scene_error(std::string(1000000, '[')), "M: JSON nested deeper than 32 levels");
  EXPECT_EQ(scene_error(std::string("{\"a\xFF\": 1}")).substr(0, 20), "M:1: not valid JSON:");
}

}  // namespace
}  // namespace ligne
