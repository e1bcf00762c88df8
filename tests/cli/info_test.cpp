#include <nlohmann/json.hpp>
#include <sstream>

#include "draw_program.hpp"
#include "forged_files.hpp"
#include "picture/models/compiled_model.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

// [Boulle1980] 1.2.2.1: what holds of a scene can be stated of it.
TEST_F(ProgramTest, InfoTellsTheFactsThatHold) {
  const json cube = json::parse(run_well("info cube.obj --json").out)["facts"];
  EXPECT_EQ(cube["assume"], "no-penetration,convex,adjacency");
  EXPECT_EQ(cube["convex"], json::parse(R"({"holds": true, "stated": false})"));
  EXPECT_TRUE(cube["separating_planes"].empty());
  expect_parts(run_well("info cube.obj").out, {"\n  to state       --assume no-penetration,convex,adjacency\n"});
  const json square = json::parse(run_well("info square.obj --json").out)["facts"];
  EXPECT_EQ(square["assume"], "no-penetration");
  EXPECT_EQ(square["adjacency"]["holds"], false);
  expect_parts(square["adjacency"]["why_not"].get<std::string>(), {"has a border edge"});
  // The plane between two objects can be copied into a scene.
  const json two = json::parse(run_well("info cube.obj square.obj --move square=40,0,0 --json").out)["facts"];
  ASSERT_EQ(two["separating_planes"].size(), 1u);
  EXPECT_EQ(two["separating_planes"][0]["normal"], json::parse("[1,0,0]"));
  const std::string plain = run_well("draw cube.obj -o - --format svg").out;
  EXPECT_EQ(run_well("draw cube.obj -o - --format svg --assume no-penetration,convex,adjacency").out, plain);
  EXPECT_EQ(json::parse(run_well("info cube.obj --assume adjacency --json").out)["facts"]["adjacency"]["stated"], true);
  const Outcome refused = run("draw square.obj -o s.svg --assume adjacency");
  EXPECT_EQ(refused.status, 2);
  expect_parts(refused.err, {"the fact 'adjacency' is false: object", "has a border edge"});
}

TEST_F(ProgramTest, InfoTextNamesEveryMethod) {
  const json methods = json::parse(run("methods --json").out);
  EXPECT_EQ(methods["format"], "ligne-methods");
  ASSERT_FALSE(methods["methods"].empty());
  const Outcome info = run_well("info square.obj --stats");
  expect_parts(info.err, {"topology"});
  const std::string list = run("methods").out;
  int defaults = 0;
  for (const json& method : methods["methods"]) {
    const std::string name = method["name"];
    expect_parts(info.out, {"\n  " + name + " "});
    expect_parts(list, {name, method["paper"].get<std::string>()});
    defaults += method["default"].get<bool>();
    ASSERT_EQ(method["parts"].size(), 7u) << name;
    std::string symbols;
    for (const json& part : method["parts"]) {
      symbols += part["symbol"].get<std::string>() + ' ';
      EXPECT_FALSE(part["text"].get<std::string>().empty()) << name;
    }
    EXPECT_EQ(symbols, "MD Td Psi sigma Ti RI MV ");
  }
  EXPECT_EQ(defaults, 1);
  expect_parts(info.out, {"open: 4 border edges"});
}

TEST_F(ProgramTest, CompareAsJsonHasOneSchemaForAllMethods) {
  const Outcome outcome = run_well("compare cube.obj --json");
  EXPECT_EQ(outcome.err, "");
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["format"], "ligne-compare");
  EXPECT_EQ(found["version"], 1);
  EXPECT_EQ(found["reference"], "appel");
  EXPECT_EQ(found["traits"]["faces"], 6);
  EXPECT_EQ(found["auto"]["method"], "appel");
  const json& methods = found["methods"];
  ASSERT_GT(methods.size(), 5u);
  for (const json& m : methods) {
    EXPECT_TRUE(m["drawn"]) << m["name"];
    ASSERT_EQ(m.size(), methods[0].size()) << m["name"];
    for (const auto& [key, value] : methods[0].items()) EXPECT_TRUE(m.contains(key)) << m["name"] << " " << key;
    for (const auto& [key, value] : methods[0]["operations"].items()) EXPECT_TRUE(m["operations"].contains(key));
    if (m["exact"] == true) {
      EXPECT_EQ(m["differs_mm"], 0) << m["name"];
    }
  }
  ASSERT_EQ(found["differences_mm"].size(), methods.size());
}

TEST_F(ProgramTest, CompareOfSomeMethodsAsCsv) {
  const Outcome outcome = run_well("compare cube.obj --methods newell,warnock --set resolution=64 --csv");
  std::vector<std::string> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind("method,exact,drawn,note,resolution_mm,", 0), 0u);
  // In the order of ligne methods; the option is that of warnock alone.
  EXPECT_EQ(lines[1].rfind("warnock,no,yes,", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind("newell,yes,yes,", 0), 0u) << lines[2];
}

/// ligne compile, and ligne draw of what it writes.

const std::filesystem::path kScenes = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus";

class CompileTest : public DrawTest {
 protected:
  std::string compiled(const std::string& model, const Words& options = {}) const {
    const Outcome outcome = run_well(Words{"compile", model, "-o", "model.tree", "-q"} + options);
    return contents(file("model.tree"));
  }
  std::string svg(const std::string& model, const Words& options) const {
    return output_of(Words{"draw", model, "-q", "-o", "-", "--format", "svg"} + options);
  }
  std::string refusal(const Words& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    return outcome.err;
  }
};

TEST_F(CompileTest, TheTreeDrawsWhatTheModelDraws) {
  for (const char* name : {"letter_e.json", "cyclic_4.json", "plate_many_holes.json", "house.json",
                           "three_plates_penetrating.json", "duplicate_parts.json"}) {
    const std::string model = (kScenes / name).string();
    for (const std::string method : {"bsp", "convex-tree"}) {
      compiled(model, {"--method", method});
      for (const Words view : {"--view iso", "--eye 5,7,4 --fov 60", "--view top --fill shade"}) {
        Words direct = view + Words{"--method", method};
        const std::string drawing = svg("model.tree", view);
        EXPECT_EQ(drawing, svg(model, direct)) << name << " " << method << " " << view[1];
        EXPECT_EQ(drawing, svg("model.tree", direct)) << name << " " << method << " " << view[1];
      }
      EXPECT_EQ(svg("model.tree", "--method appel"), svg(model, "--method appel")) << name;
    }
  }
}

TEST_F(CompileTest, DamagedFilesAreRefused) {
  const std::string bytes = compiled("cube.obj");
  const auto error_of = [&](const std::string& changed) {
    write("changed.tree", changed);
    return refusal("draw changed.tree -o a.svg");
  };
  const std::string damaged = "ligne: changed.tree: byte 12: the file was changed or cut off since it was written\n";
  EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2)), damaged);
  EXPECT_EQ(error_of(bytes + "x"), damaged);
  std::string changed = bytes;
  changed[changed.size() / 2] ^= 4;
  EXPECT_EQ(error_of(changed), damaged);
  changed = bytes;
  changed[12] = 7;
  expect_parts(error_of(changed), {"of version 7; this program reads version 1"});
  EXPECT_FALSE(exists("a.svg"));
}

/// Nothing is believed of a forged file: every byte in turn, with the checksum made to fit.
TEST_F(CompileTest, ForgedFilesAreReadOrRefused) {
  for (const char* method : {"bsp", "convex-tree"}) {
    const std::string bytes = compiled((kScenes / "cyclic_4.json").string(), {"--method", method});
    expect_forgeries_are_refused(bytes, sign_compiled_model, read_compiled_model);
  }
}

}  // namespace
}  // namespace ligne::test
