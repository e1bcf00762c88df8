/// Model files through the command: warnings of what is left out, materials of OBJ, moments of animations, glass.

#include <regex>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class ModelFilesTest : public DrawTest {
 protected:
  void SetUp() override {
    DrawTest::SetUp();
    write("red_glass.mtl", "newmtl glass\nKd 1 0 0\nd 0.5\nmap_Kd pane.png\n");
    write("pane.obj",
          "mtllib red_glass.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.2 -1\nv 0.8 0.2 -1\nv 0.5 0.8 -1\n"
          "usemtl glass\nf 1 2 3 4\nusemtl wood\nf 5 6 7\nl 1 2\n");
    // A triangle that moves by 10 a second.
    write("moves.gltf",
          R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
      "animations":[{"name":"slide","samplers":[{"input":1,"output":2}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}],
      "buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAACBBAAAAAAAAAAA="}],
      "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLength":24}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR"},
      {"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"}]})");
  }
};

TEST_F(ModelFilesTest, OneWarningNamesWhatIsLeftOut) {
  const Outcome outcome = run_well("draw pane.obj -o x.svg");
  EXPECT_EQ(outcome.err, "ligne: pane.obj: warning: left out: 1 lines (l), 1 textures (map_Kd)\n");
  EXPECT_NE(run("info pane.obj").out.find("left out       1 lines (l), 1 textures (map_Kd)"), std::string::npos);
  const json info = json::parse(run("info pane.obj --json").out);
  EXPECT_EQ(info["files"][0]["left_out"]["lines (l)"], 1);
}

TEST_F(ModelFilesTest, LibrariesOfMaterialsAreDrawn) {
  run_well("draw pane.obj -q --view front --fill material -o x.svg");
  const std::string svg = contents(file("x.svg"));
  EXPECT_NE(svg.find("fill-opacity=\"0.5\""), std::string::npos) << svg;
  EXPECT_TRUE(svg.find("fill=\"#f00\"") != std::string::npos || svg.find("fill=\"#ff0000\"") != std::string::npos) << svg;
  // Nothing may be written over a file that was read.
  EXPECT_EQ(run("draw pane.obj -q --format svg -o red_glass.mtl").status, kUsage);
}

TEST_F(ModelFilesTest, GlassIsSeenThroughByItself) {
  run_well("draw pane.obj -q --view front -o x.svg");
  EXPECT_NE(contents(file("x.svg")).find("id=\"behind-glass\""), std::string::npos);
  run_well("draw pane.obj -q --view front -o chosen.json");
  run_well("draw pane.obj -q --view front --method atherton-weiler -o named.json");
  const json chosen = json::parse(contents(file("chosen.json"))), named = json::parse(contents(file("named.json")));
  EXPECT_FALSE(chosen["regions"].empty());
  EXPECT_EQ(chosen["regions"], named["regions"]);
  const Outcome opaque = run("draw pane.obj --view front --method appel -o x.svg");
  EXPECT_NE(opaque.err.find(
                "warning: 1 transparent faces are drawn as opaque; --method atherton-weiler draws them as transparent\n"),
            std::string::npos)
      << opaque.err;
}

TEST_F(ModelFilesTest, PosesMoveTheModel) {
  const auto middle = [&](const Words& options) {
    return json::parse(run("info moves.gltf --json" + options).out)["scene"]["bounds"];
  };
  EXPECT_EQ(middle({}), middle("--pose slide@0"));
  EXPECT_NE(middle({}), middle("--pose slide@0.5"));
  EXPECT_EQ(middle("--pose 0@0.5"), middle("--pose slide@0.5"));
  const Outcome none = run("draw moves.gltf --pose jump@1 -o x.svg");
  EXPECT_EQ(none.status, kFailed);
  EXPECT_EQ(none.err, "ligne: moves.gltf: has no animation \"jump\"; there are 0 slide\n");
  for (const char* wrong : {"slide", "@1", "slide@", "slide@soon"}) {
    EXPECT_EQ(run({"draw", "moves.gltf", "--pose", wrong, "-o", "x.svg"}).status, kUsage) << wrong;
  }
}

TEST_F(ModelFilesTest, APageThatNoPaperOfTheDeviceHolds) {
  const Outcome fitted = run_well("draw cube.obj --device hp7475a --page A2 -o x.hpgl");
  EXPECT_NE(fitted.err.find("warning: no paper of hp7475a holds a page of 420 x 594 mm: the drawing is made for A3\n"),
            std::string::npos)
      << fitted.err;
  const Outcome refused = run("draw cube.obj --device hp7475a --page A2 --scale 1:1 -o y.hpgl");
  EXPECT_EQ(refused.status, kFailed);
  EXPECT_NE(refused.err.find("no paper holds a page of 420 mm x 594 mm"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace ligne::test
