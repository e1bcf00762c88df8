#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

TEST_F(ProgramTest, InfoCountsACube) {
  const Outcome outcome = run({"info", "cube.obj", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json info = json::parse(outcome.out);
  EXPECT_EQ(info["format"], "ligne-info");
  EXPECT_EQ(info["version"], 1);
  EXPECT_EQ(info["files"][0]["stored"]["faces"], 6);
  EXPECT_EQ(info["files"][0]["stored"]["triangles"], 12);
  const json& scene = info["scene"];
  EXPECT_EQ(scene["vertices"], 8);
  EXPECT_EQ(scene["faces"], 6);
  EXPECT_EQ(scene["faces_with_holes"], 0);
  EXPECT_EQ(scene["edges"], 12);
  EXPECT_EQ(scene["border_edges"], 0);
  EXPECT_EQ(scene["bounds"], json::parse("[[-10,-10,-10],[10,10,10]]"));
  EXPECT_EQ(scene["up_axis"], "y");
  ASSERT_EQ(scene["objects"].size(), 1u);
  EXPECT_EQ(scene["objects"][0]["name"], "cube");
  EXPECT_EQ(scene["objects"][0]["closed"], true);
  EXPECT_EQ(scene["objects"][0]["windings_agree"], true);
  // Seen from a corner: six edges around the outline, three before, three behind.
  EXPECT_EQ(info["view"]["edges"]["outline"], 6);
  EXPECT_EQ(info["view"]["edges"]["crease"], 6);
  EXPECT_EQ(info["view"]["edges"]["mesh"], 0);
  EXPECT_FALSE(info["methods"].empty());
}

TEST_F(ProgramTest, InfoFollowsTheView) {
  const Outcome front =
      run({"info", "square.obj", "--json", "--view", "front", "--scale", "1:2", "--unit", "cm", "--page", "A3"});
  ASSERT_EQ(front.status, 0) << front.err;
  const json view = json::parse(front.out)["view"];
  EXPECT_EQ(view["edges"]["border"], 4);
  EXPECT_NEAR(view["picture_mm"][0].get<double>(), 200, 1e-6);
  EXPECT_NEAR(view["picture_mm"][1].get<double>(), 50, 1e-6);
  EXPECT_EQ(view["page_mm"], json::parse("[420,297]"));
  EXPECT_NEAR(view["mm_per_unit"].get<double>(), 5, 1e-12);
}

TEST_F(ProgramTest, InfoTellsWhatCullLeavesOut) {
  const Outcome culled = run({"info", "cube.obj", "square.obj", "--cull", "--json"});
  ASSERT_EQ(culled.status, 0) << culled.err;
  const json view = json::parse(culled.out)["view"];
  EXPECT_EQ(view["culled"], json::parse(R"({"faces":3,"objects":1,"kept_objects":1})"));
  EXPECT_EQ(view["edges"]["crease"], 3) << "those behind the cube are gone";
  EXPECT_NE(culled.err.find("warning: 1 of 2 objects"), std::string::npos);
  EXPECT_NE(run({"info", "cube.obj", "--cull"}).out.find("3 left out, of 1 of 1 objects"), std::string::npos);
  EXPECT_FALSE(json::parse(run({"info", "cube.obj", "--json"}).out)["view"].contains("culled"));
}

TEST_F(ProgramTest, InfoTextNamesEveryMethod) {
  const json methods = json::parse(run({"methods", "--json"}).out);
  EXPECT_EQ(methods["format"], "ligne-methods");
  ASSERT_FALSE(methods["methods"].empty());
  const Outcome info = run({"info", "square.obj", "--stats"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.err.find("topology"), std::string::npos);
  const std::string list = run({"methods"}).out;
  int defaults = 0;
  for (const json& method : methods["methods"]) {
    const std::string name = method["name"];
    EXPECT_NE(info.out.find("\n  " + name + " "), std::string::npos) << info.out;
    EXPECT_NE(list.find(name), std::string::npos);
    EXPECT_NE(list.find(method["paper"].get<std::string>()), std::string::npos);
    defaults += method["default"].get<bool>();
  }
  EXPECT_EQ(defaults, 1);
  EXPECT_NE(info.out.find("open: 4 border edges"), std::string::npos) << info.out;
}

TEST_F(ProgramTest, InfoWritesFilesAndTakesSeveralModels) {
  const Outcome outcome = run({"info", "cube.obj", "square.obj", "--format", "json", "-o", "info.txt", "--up-axis", "z"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const json info = json::parse(contents(file("info.txt")));
  EXPECT_EQ(info["files"].size(), 2u);
  EXPECT_EQ(info["scene"]["objects"].size(), 2u);
  EXPECT_EQ(info["scene"]["up_axis"], "z");
}

TEST_F(ProgramTest, HelpAndVersion) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("ligne ", 0), 0u);
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"draw", "info", "methods"}) {
    EXPECT_NE(help.out.find(command), std::string::npos);
    const Outcome of_command = run({command, "--help"});
    EXPECT_EQ(of_command.status, 0);
    EXPECT_EQ(of_command.err, "");
    EXPECT_NE(of_command.out.find("Example"), std::string::npos);
  }
  const std::string draw = run({"draw", "--help"}).out;
  for (const char* option : {"--view",      "--direction",      "--eye",       "--target",     "--fov",
                             "--up",        "--up-axis",        "--method",    "--edges",      "--crease",
                             "--hidden",    "--page",           "--landscape", "--portrait",   "--margin",
                             "--pen-width", "--scale",          "--unit",      "--output",     "--format",
                             "--dpi",       "--threads",        "--stats",     "--stats-json", "--progress",
                             "--quiet",     "--merge-coplanar", "--title",     "--cull",       "--weld"}) {
    EXPECT_NE(draw.find(option), std::string::npos) << option;
  }
  EXPECT_NE(draw.find("svg pdf png json"), std::string::npos);
  EXPECT_EQ(run({"info", "--help"}).out.find("svg"), std::string::npos) << "info is no drawing";
}

}  // namespace
}  // namespace ligne::test
