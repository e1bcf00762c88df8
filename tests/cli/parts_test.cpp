/// Objects by name: --only, --hide, --move, --group, --color, --pen object:NAME.

#include <cmath>
#include <regex>
#include <set>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class PartsTest : public DrawTest {
 protected:
  void SetUp() override {
    DrawTest::SetUp();
    // Three squares side by side, seen from the front; the last two have the same name but for a blank.
    write("squares.json", R"({"format": "ligne-scene", "version": 1, "objects": [
      {"name": "left, <1>", "vertices": [[0,0,0], [2,0,0], [2,0,2], [0,0,2]], "faces": [{"outer": [0,1,2,3]}]},
      {"name": "mid dle", "vertices": [[3,0,0], [5,0,0], [5,0,2], [3,0,2]], "faces": [{"outer": [0,1,2,3]}]},
      {"name": "mid_dle", "vertices": [[6,0,0], [8,0,0], [8,0,2], [6,0,2]], "faces": [{"outer": [0,1,2,3]}]},
      {"vertices": [[9,0,0], [11,0,0], [11,0,2], [9,0,2]], "faces": [{"outer": [0,1,2,3]}]}]})");
  }

  std::size_t strokes(const Words& options) const {
    return drawn(Words{"squares.json", "--view", "front"} + options)["strokes"].size();
  }
  Outcome refused(const Words& options) const { return run("draw squares.json --view front -o x.svg" + options); }
};

TEST_F(PartsTest, AreChosenByPatternsOfNames) {
  for (const char* quality : {"clear", "exact"}) {
    EXPECT_EQ(strokes({"--quality", quality}), 16u);
    EXPECT_EQ(strokes({"--quality", quality, "--only", "mid*"}), 8u);
    EXPECT_EQ(strokes({"--quality", quality, "--only", "mid?dle,object 3"}), 12u);
    EXPECT_EQ(strokes({"--quality", quality, "--only", "mid dle", "--only", "left*"}), 8u);
    EXPECT_EQ(strokes({"--quality", quality, "--only", "left\\, <1>"}), 4u) << "a comma of the name";
    EXPECT_EQ(strokes({"--quality", quality, "--hide", "mid[_ ]dle"}), 8u);
    EXPECT_EQ(strokes({"--quality", quality, "--only", "mid*", "--hide", "*_*"}), 4u);
  }
  const json info = json::parse(run("info squares.json --json --hide left*").out);
  EXPECT_EQ(info["scene"]["objects"].size(), 3u);
  EXPECT_EQ(info["scene"]["objects"][2]["name"], "object 3") << "the number is that in the whole scene";
}

TEST_F(PartsTest, ThatAreNotThereAreNamed) {
  EXPECT_EQ(refused("--only wheel").err,
            "ligne: --only: no object is called \"wheel\"; there are left, <1>, mid dle, mid_dle, object 3\n");
  EXPECT_EQ(refused("--hide Mid*").status, 2);
  EXPECT_EQ(refused("--move x=1,0,0").err.rfind("ligne: --move: no object is called \"x\"; there are", 0), 0u);
  EXPECT_EQ(refused("--color x=red").err.rfind("ligne: --color: no object is called", 0), 0u);
  EXPECT_EQ(refused("--pen object:x=2").err.rfind("ligne: --pen: no object is called", 0), 0u);
  EXPECT_EQ(refused("--hide *").err, "ligne: --hide: no object is left to draw\n");
  for (const char* wrong : {"mid*", "mid*=1,2", "=1,2,3", "mid*=1,2,x", "mid*=1,2,3ft"}) {
    EXPECT_EQ(refused({"--move", wrong}).status, 2) << wrong;
  }
  EXPECT_EQ(refused("--only a,,b").status, 2);
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(PartsTest, AreMovedInModelUnitsOrLengths) {
  const auto right_end = [&](const char* by) {
    const json drawing = drawn({"squares.json", "--view", "front", "--scale", "1:1", "--unit", "cm", "--only", "mid*",
                                "--move", by, "--page", "400x200"});
    double least = 1e9, most = -1e9;
    for (const json& s : drawing["strokes"]) {
      for (const json& p : s["points"]) {
        least = std::min(least, p[0].get<double>());
        most = std::max(most, p[0].get<double>());
      }
    }
    return most - least;
  };
  EXPECT_NEAR(right_end("mid_dle=0,0,0"), 50, 1e-3);
  EXPECT_NEAR(right_end("mid_dle=2,0,0"), 70, 1e-3);
  EXPECT_NEAR(right_end("mid_dle=25mm,0,0"), 75, 1e-3);
  EXPECT_NEAR(right_end("mid_dle=0.1m,0,0"), 150, 1e-3);
  EXPECT_NEAR(right_end("mid dle=-1.5cm,0,0"), 65, 1e-3);
  EXPECT_NEAR(right_end("*=3,0,0"), 50, 1e-3) << "all together";
}

/// Objects that are left out take no part in healing: the second of two equal objects is drawn where the first is hidden.
TEST_F(PartsTest, AreLeftOutBeforeAnythingIsMended) {
  write("twice.json", R"({"format": "ligne-scene", "version": 1, "objects": [
    {"name": "a", "vertices": [[0,0,0], [2,0,0], [2,0,2], [0,0,2]], "faces": [{"outer": [0,1,2,3]}]},
    {"name": "b", "vertices": [[0,0,0], [2,0,0], [2,0,2], [0,0,2]], "faces": [{"outer": [0,1,2,3]}]}]})");
  EXPECT_EQ(drawn("twice.json --view front -q --hide a")["strokes"].size(), 4u);
  EXPECT_EQ(drawn("twice.json --view front -q --move a=0,0,4")["strokes"].size(), 8u);
}

TEST_F(PartsTest, AreGroupsWithUniqueIds) {
  const Outcome svg = run_well("draw squares.json --view front --group object --color mid*=#00f -o - --format svg");
  const std::regex group("<g [^>]*id=\"([^\"]*)\"[^>]*>");
  std::vector<std::string> ids;
  for (auto m = std::sregex_iterator(svg.out.begin(), svg.out.end(), group); m != std::sregex_iterator(); ++m) {
    ids.push_back((*m)[1]);
  }
  EXPECT_EQ(ids, (Words("border border-left___1_ border-mid_dle border-mid_dle-2 border-object_3")));
  expect_parts(svg.out, {"<g inkscape:label=\"left, &lt;1&gt;\" id=\"border-left___1_\">",
                         "id=\"border-mid_dle-2\" stroke=\"#00f\">"});

  const json drawing = drawn("squares.json --view front --group object");
  EXPECT_EQ(drawing["objects"], json::parse(R"(["left, <1>", "mid dle", "mid_dle", "object 3"])"));
  std::multiset<int> of_strokes;
  for (const json& s : drawing["strokes"]) of_strokes.insert(s["object"].get<int>());
  for (int object = 0; object < 4; ++object) EXPECT_EQ(of_strokes.count(object), 4u);
  EXPECT_FALSE(drawn("squares.json --view front").contains("objects"));
}

TEST_F(PartsTest, HaveColoursAndPens) {
  const auto bytes = [&](const Words& more) { return output_of("draw squares.json --view front -o -" + more); };
  const std::string svg = bytes("--format svg --color *=red --color left*=#0f0");
  expect_parts(svg, {"<g stroke=\"#f00\">", "<g stroke=\"#0f0\">"});
  EXPECT_NE(bytes("--format png --color *=red"), bytes("--format png"));
  EXPECT_NE(bytes("--format pdf --color *=red"), bytes("--format pdf"));
  const std::string hpgl = bytes("--format hpgl --pen rest=1 --pen object:mid*=3");
  expect_parts(hpgl, {"SP1;", "SP3;"});
  EXPECT_EQ(refused("--color *=red --pen rest=1").status, 2);
  EXPECT_EQ(run("draw squares.json --color *=red -o x.json").status, 2);
  EXPECT_EQ(refused("--color *=reddish").status, 2);
}

/// Groups of an OBJ are parts where it has no objects, and where parts are told apart.
TEST_F(PartsTest, MayBeGroupsOfAnObj) {
  const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 0 0\nv 4 2 0\n";
  write("groups.obj", vertices + "g left\nf 1 2 3 4\ng right\nf 2 5 6 3\n");
  write("objects.obj", vertices + "o all\ng left\nf 1 2 3 4\ng right\nf 2 5 6 3\n");
  const auto count = [&](Words options) {
    options.insert(options.begin() + 1, {"--view", "front"});
    return drawn(options)["strokes"].size();
  };
  EXPECT_EQ(count("groups.obj"), 6u) << "one sheet";
  EXPECT_EQ(count("groups.obj --only left"), 4u);
  EXPECT_EQ(json::parse(run("info groups.obj --json").out)["files"][0]["groups"], json::parse(R"(["left", "right"])"));
  EXPECT_EQ(count("objects.obj --only all"), 6u);
  EXPECT_EQ(run("draw objects.obj --only left -o x.svg").status, 2);
  EXPECT_FALSE(json::parse(run("info objects.obj --json").out)["files"][0].contains("groups"));
}

/// A triangle of 0.1 by 0.05 m as glTF.
TEST_F(PartsTest, AGltfIsInMetres) {
  write("m.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "name": "sheet"}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0,0,0], "max": [0.10000000149,0.05000000075,0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MTD0AAAAA"}]})");
  const auto width = [&](const Words& more) {
    const Outcome outcome = run_well("info m.gltf --json --view front --scale 1:1" + more);
    return json::parse(outcome.out)["view"]["picture_mm"][0].get<double>();
  };
  EXPECT_NEAR(width({}), 100, 1e-3);
  EXPECT_NEAR(width("--unit mm"), 0.1, 1e-6);
  EXPECT_EQ(json::parse(run("info m.gltf --json").out)["scene"]["unit_mm"], 1000);
  EXPECT_EQ(json::parse(run("info cube.obj --json").out)["scene"]["unit_mm"], 1);
}

}  // namespace
}  // namespace ligne::test
