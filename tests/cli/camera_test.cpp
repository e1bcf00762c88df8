/// Cameras of model files: --view camera[:NAME].

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class CameraTest : public DrawTest {
 protected:
  json strokes(const std::string& model, std::vector<std::string> options) const {
    return view(model, std::move(options))[1];
  }
  json view(const std::string& model, std::vector<std::string> options) const {
    options.insert(options.begin(), model);
    const json drawing = drawn(options);
    return {drawing["view"]["matrix"], drawing["strokes"]};
  }
};

const std::string kTriangle = R"(Named object: "plate"
Tri-mesh, Vertices: 3 Faces: 1
Vertex list:
Vertex 0: X: 0 Y: 0 Z: 0
Vertex 1: X: 4 Y: 0 Z: 0
Vertex 2: X: 0 Y: 6 Z: 2
Face list:
Face 0: A:0 B:1 C:2 AB:1 BC:1 CA:1
)";

TEST_F(CameraTest, Of3dStudioHaveAFilmOf24Millimetres) {
  // 12 mm and half of the 24 mm of the film: 45 degrees on either side of the middle.
  write("plate.asc", kTriangle + R"(Named object: "first"
Camera (12mm)
Position: X:2 Y:-9 Z:5
Target: X:2 Y:3 Z:1
Bank angle: 0 degrees
Named object: "second"
Camera (50mm)
Position: X:2 Y:-20 Z:5
Target: X:2 Y:4 Z:5
Bank angle: 90 degrees
)");
  // The true scale holds in the middle of the plate (2, 3, 1), which the first camera looks at.
  EXPECT_EQ(strokes("plate.asc", {"--view", "camera"}),
            strokes("plate.asc", {"--eye", "2,-9,5", "--target", "2,3,1", "--fov", "90"}));
  EXPECT_EQ(view("plate.asc", {"--view", "camera:f*"}), view("plate.asc", {"--view", "camera:first"}));
  // A quarter of a turn: what is to the right becomes up.
  const json matrix = view("plate.asc", {"--view", "camera:second"})[0];
  EXPECT_NEAR(matrix[0].get<double>() / matrix[4].get<double>(), 0, 1e-9);
  EXPECT_LT(matrix[4].get<double>(), 0);
}

TEST_F(CameraTest, OfGltfLookAlongTheirNode) {
  write("plate.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
    "nodes": [{"mesh": 0}, {"name": "eye", "camera": 0, "translation": [0.5, 0.3, 4]},
              {"name": "flat", "camera": 1, "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]},
              {"name": "broken", "camera": 0, "scale": [0, 0, 0]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1.5707963267948966, "znear": 0.1}},
                {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36,
                 "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  EXPECT_EQ(strokes("plate.gltf", {"--view", "camera"}),
            strokes("plate.gltf", {"--eye", "0.5,0.3,4", "--target", "0.5,0.3,0", "--fov", "90"}));
  // Turned by a quarter to the left the camera looks along -x.
  const json flat = view("plate.gltf", {"--view", "camera:flat"})[0];
  EXPECT_NEAR(flat[0].get<double>(), 0, 1e-9);
  EXPECT_LT(flat[2].get<double>(), 0);
  const json info = json::parse(run({"info", "plate.gltf", "--json", "-q"}).out);
  EXPECT_EQ(info["scene"]["cameras"], json({"eye", "flat"}));
}

TEST_F(CameraTest, OfGltfWithoutANameHaveTheirNumber) {
  write("plate.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
    "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.5, 0.3, 4]}, {"camera": 1, "translation": [0.5, 0.3, 3]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1.5707963267948966, "znear": 0.1}},
                {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36,
                 "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  EXPECT_EQ(strokes("plate.gltf", {"--view", "camera:1"}), strokes("plate.gltf", {"--view", "camera"}));
  EXPECT_EQ(strokes("plate.gltf", {"--view", "camera:2"}), strokes("plate.gltf", {"--direction", "0,0,-1"}));
  EXPECT_EQ(run({"draw", "plate.gltf", "--view", "camera:3", "-o", "a.svg"}).err,
            "ligne: --view: no camera is called \"3\"; there are 1, 2\n");
}

TEST_F(CameraTest, ThatAreNotThereAreNamed) {
  write("plate.asc", kTriangle + "Named object: \"only\"\nCamera (50mm)\nPosition: X:0 Y:0 Z:9\nTarget: X:0 Y:0 Z:0\n");
  EXPECT_EQ(run({"draw", "cube.obj", "--view", "camera", "-o", "a.svg"}).err, "ligne: --view: the model has no camera\n");
  EXPECT_EQ(run({"draw", "plate.asc", "--view", "camera:x", "-o", "a.svg"}).err,
            "ligne: --view: no camera is called \"x\"; there is only\n");
  EXPECT_EQ(run({"draw", "plate.asc", "--view", "camera", "--eye", "1,2,3", "-o", "a.svg"}).status, 2);
}

}  // namespace
}  // namespace ligne::test
