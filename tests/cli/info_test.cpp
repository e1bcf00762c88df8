#include <nlohmann/json.hpp>
#include <sstream>

#include "draw_program.hpp"
#include "forged_files.hpp"
#include "picture/models/compiled_model.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

TEST_F(ProgramTest, InfoCountsACube) {
  const Outcome outcome = run_well("info cube.obj --json");
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
  const Outcome front = run_well("info square.obj --json --view front --scale 1:2 --unit cm --page A3");
  const json view = json::parse(front.out)["view"];
  EXPECT_EQ(view["edges"]["border"], 4);
  EXPECT_NEAR(view["picture_mm"][0].get<double>(), 200, 1e-6);
  EXPECT_NEAR(view["picture_mm"][1].get<double>(), 50, 1e-6);
  EXPECT_EQ(view["page_mm"], json::parse("[420,297]"));
  EXPECT_NEAR(view["mm_per_unit"].get<double>(), 5, 1e-12);
}

TEST_F(ProgramTest, InfoTellsWhatCullLeavesOut) {
  const Outcome culled = run_well("info cube.obj square.obj --cull --json");
  const json view = json::parse(culled.out)["view"];
  EXPECT_EQ(view["culled"], json::parse(R"({"faces":3,"objects":1,"kept_objects":1})"));
  EXPECT_EQ(view["edges"]["crease"], 3) << "those behind the cube are gone";
  expect_parts(culled.err, {"warning: 1 of 2 objects"});
  EXPECT_NE(run("info cube.obj --cull").out.find("3 left out, of 1 of 1 objects"), std::string::npos);
  EXPECT_FALSE(json::parse(run("info cube.obj --json").out)["view"].contains("culled"));
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

TEST_F(ProgramTest, InfoWritesFilesAndTakesSeveralModels) {
  const Outcome outcome = run_well("info cube.obj square.obj --format json -o info.txt --up-axis z");
  EXPECT_EQ(outcome.out, "");
  const json info = json::parse(contents(file("info.txt")));
  EXPECT_EQ(info["files"].size(), 2u);
  EXPECT_EQ(info["scene"]["objects"].size(), 2u);
  EXPECT_EQ(info["scene"]["up_axis"], "z");
}

TEST_F(ProgramTest, HelpAndVersion) {
  const Outcome version = run_well("--version");
  EXPECT_EQ(version.out.rfind("ligne ", 0), 0u);
  const Outcome help = run_well("--help");
  for (const char* command : {"draw", "info", "methods"}) {
    expect_parts(help.out, {command});
    const Outcome of_command = run_well({command, "--help"});
    EXPECT_EQ(of_command.err, "");
    expect_parts(of_command.out, {"Example"});
  }
  const std::string draw = run("draw --help all").out;
  for (const char* option : {"--view",      "--direction",      "--eye",       "--target",     "--fov",
                             "--up",        "--up-axis",        "--method",    "--edges",      "--crease",
                             "--hidden",    "--page",           "--landscape", "--portrait",   "--margin",
                             "--pen-width", "--scale",          "--unit",      "--output",     "--format",
                             "--dpi",       "--threads",        "--stats",     "--stats-json", "--progress",
                             "--quiet",     "--merge-coplanar", "--title",     "--cull",       "--weld"}) {
    EXPECT_NE(draw.find(option), std::string::npos) << option;
  }
  expect_parts(draw, {"svg pdf png json"});
  EXPECT_EQ(run("info --help").out.find("svg"), std::string::npos) << "info is no drawing";
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

TEST_F(ProgramTest, ComparePageNeedsNothingElse) {
  const Outcome outcome = run_well("compare cube.obj --html cube.html -o table.txt");
  EXPECT_EQ(outcome.out, "");
  const std::string page = contents(file("cube.html"));
  EXPECT_EQ(page.rfind("<!doctype html>", 0), 0u);
  for (const char* from_outside : {"http:", "https:", "src=", "@import", "<script", "<link"}) {
    EXPECT_EQ(page.find(from_outside), std::string::npos) << from_outside;
  }
  expect_parts(page, {"exact methods draw the same lines", "<svg", "The seven parts",
                      "<th>sigma<small>strategy</small></th>", "<code>ProjectedScene</code>"});
  EXPECT_NE(contents(file("table.txt")).find("appel"), std::string::npos);
}

TEST_F(ProgramTest, CompareRefusesWhatMakesNoSense) {
  const auto refused = [&](const Words& arguments, const std::string& why) {
    expect_outcome("compare cube.obj" + arguments, 2, {why});
  };
  refused("--methods magic", "--methods: \"magic\" is not one of auto");
  refused("--methods appel,appel", "--methods: \"appel\" is given twice");
  refused("--methods auto", "--methods: auto stands for one of the other methods");
  refused("--hidden dashed:1", "--hidden: only --method appel counts faces");
  refused("--methods appel --set resolution=64", "--set resolution: no method has this option");
  refused("--json --csv", "--");
  EXPECT_EQ(new_files(), Words{});
}

TEST_F(ProgramTest, StatsSayWhichRuleChose) {
  const Outcome outcome = run_well("draw cube.obj -o x.svg --stats");
  expect_parts(outcome.err, {"rule 4: any other scene"});
}

// ligne study: the names, what is refused, and the files that it writes.

using StudyCommandTest = ProgramTest;

TEST_F(StudyCommandTest, ListsTheExperiments) {
  const Outcome outcome = run_well("study --list");
  expect_parts(outcome.out, {"squares", "Boulle 2.3.3.4"});
}

TEST_F(StudyCommandTest, WritesTablesAndPlots) {
  const Outcome outcome = run_well("study translation --size small --json t.json --csv t.csv --svg t.svg");
  expect_parts(outcome.out, {"Figure 2.56"});
  const auto json = nlohmann::json::parse(contents(file("t.json")));
  EXPECT_EQ(json["format"], "ligne-study");
  EXPECT_EQ(json["size"], "small");
  EXPECT_EQ(json["experiments"].size(), 1u);
  EXPECT_EQ(contents(file("t.csv")).rfind("experiment,table,row,column,kind,value\n", 0), 0u);
  const std::string svg = contents(file("t.svg"));
  expect_parts(svg, {"<svg"});
  expect_no_parts(svg, {"nan"});
}

TEST_F(StudyCommandTest, StandardOutputHasWhatWasAskedFor) {
  const Outcome outcome = run_well("study windows --size small --json -");
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["experiments"][0]["name"], "windows");
}

TEST_F(StudyCommandTest, StudiesModelsBesideItsOwnScenes) {
  const Outcome outcome = run_well("study coherence cube.obj --size small");
  expect_parts(outcome.out, {"| cube | 256 |"});
}

TEST_F(StudyCommandTest, RefusesInOneLine) {
  for (const Words arguments : {"study", "study nothing", "study squares --size huge"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments.back();
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  }
  EXPECT_EQ(run("study windows --size small --svg w.svg").status, 1) << "it has no plot";
  EXPECT_FALSE(exists("w.svg"));
  EXPECT_EQ(run("study coherence none.obj").status, 1);
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

TEST_F(CompileTest, IsDoneOnce) {
  compiled("cube.obj");
  EXPECT_NE(run("draw cube.obj --method bsp --stats -o a.svg").err.find("\n  tree "), std::string::npos);
  EXPECT_EQ(run("draw model.tree --stats -o a.svg").err.find("\n  tree "), std::string::npos);
}

TEST_F(CompileTest, TheSameModelGivesTheSameBytes) {
  const std::string model = (kScenes / "house.json").string();
  EXPECT_EQ(compiled(model, "--threads 1"), compiled(model, "--threads 3"));
  EXPECT_NE(compiled(model), compiled(model, "--set partition=faces --set candidates=9"));
}

TEST_F(CompileTest, WhatItWasCompiledWithStays) {
  compiled("cube.obj");
  const std::string again = "model.tree is compiled: use this option with ligne compile\n";
  EXPECT_EQ(refusal("draw model.tree --weld 1 -o a.svg"), "ligne: --weld: " + again);
  EXPECT_EQ(refusal("draw model.tree --only x -o a.svg"), "ligne: --only: " + again);
  EXPECT_EQ(refusal("draw model.tree --set candidates=3 -o a.svg"), "ligne: --set candidates: " + again);
  EXPECT_EQ(refusal("draw model.tree cube.obj -o a.svg"),
            "ligne: model.tree is a compiled model and must be the only one\n");
  EXPECT_EQ(refusal("compile model.tree -o b.tree"), "ligne: model.tree is compiled already\n");
  EXPECT_EQ(refusal("compile cube.obj --method appel -o b.tree"),
            "ligne: --method: \"appel\" is not one of bsp or convex-tree\n");
  EXPECT_EQ(refusal("compile cube.obj"), "ligne: --output: there is no output file: -o FILE\n");
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
