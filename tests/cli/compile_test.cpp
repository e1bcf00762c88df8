/// ligne compile, and ligne draw of what it writes.

#include "draw_program.hpp"
#include "forged_files.hpp"
#include "picture/compiled_model.hpp"

namespace ligne::test {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus";

class CompileTest : public DrawTest {
 protected:
  std::string compiled(const std::string& model, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"compile", model, "-o", "model.tree", "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return contents(file("model.tree"));
  }
  std::string svg(const std::string& model, std::vector<std::string> options) const {
    options.insert(options.begin(), {"draw", model, "-q", "-o", "-", "--format", "svg"});
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
  std::string refusal(std::vector<std::string> arguments) const {
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
      for (const std::vector<std::string>& view : {std::vector<std::string>{"--view", "iso"},
                                                   {"--eye", "5,7,4", "--fov", "60"},
                                                   {"--view", "top", "--fill", "shade"}}) {
        std::vector<std::string> direct = view;
        direct.insert(direct.end(), {"--method", method});
        const std::string drawing = svg("model.tree", view);
        EXPECT_EQ(drawing, svg(model, direct)) << name << " " << method << " " << view[1];
        EXPECT_EQ(drawing, svg("model.tree", direct)) << name << " " << method << " " << view[1];
      }
      EXPECT_EQ(svg("model.tree", {"--method", "appel"}), svg(model, {"--method", "appel"})) << name;
    }
  }
}

TEST_F(CompileTest, IsDoneOnce) {
  compiled("cube.obj");
  EXPECT_NE(run({"draw", "cube.obj", "--method", "bsp", "--stats", "-o", "a.svg"}).err.find("\n  tree "), std::string::npos);
  EXPECT_EQ(run({"draw", "model.tree", "--stats", "-o", "a.svg"}).err.find("\n  tree "), std::string::npos);
}

TEST_F(CompileTest, TheSameModelGivesTheSameBytes) {
  const std::string model = (kScenes / "house.json").string();
  EXPECT_EQ(compiled(model, {"--threads", "1"}), compiled(model, {"--threads", "3"}));
  EXPECT_NE(compiled(model), compiled(model, {"--partition", "faces", "--candidates", "9"}));
}

TEST_F(CompileTest, WhatItWasCompiledWithStays) {
  compiled("cube.obj");
  const std::string again = "model.tree is compiled: give it to ligne compile\n";
  EXPECT_EQ(refusal({"draw", "model.tree", "--weld", "1", "-o", "a.svg"}), "ligne: --weld: " + again);
  EXPECT_EQ(refusal({"draw", "model.tree", "--only", "x", "-o", "a.svg"}), "ligne: --only: " + again);
  EXPECT_EQ(refusal({"draw", "model.tree", "--candidates", "3", "-o", "a.svg"}), "ligne: --candidates: " + again);
  EXPECT_EQ(refusal({"draw", "model.tree", "cube.obj", "-o", "a.svg"}),
            "ligne: model.tree is compiled: it is drawn alone\n");
  EXPECT_EQ(refusal({"compile", "model.tree", "-o", "b.tree"}), "ligne: model.tree is compiled already\n");
  EXPECT_EQ(refusal({"compile", "cube.obj", "--method", "appel", "-o", "b.tree"}),
            "ligne: --method: \"appel\" is not one of bsp or convex-tree\n");
  EXPECT_EQ(refusal({"compile", "cube.obj"}), "ligne: --output: there is no output file: -o FILE\n");
}

TEST_F(CompileTest, DamagedFilesAreRefused) {
  const std::string bytes = compiled("cube.obj");
  const auto error_of = [&](const std::string& changed) {
    write("changed.tree", changed);
    return refusal({"draw", "changed.tree", "-o", "a.svg"});
  };
  const std::string damaged = "ligne: changed.tree: byte 12: the file was changed or cut off since it was written\n";
  EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2)), damaged);
  EXPECT_EQ(error_of(bytes + "x"), damaged);
  std::string changed = bytes;
  changed[changed.size() / 2] ^= 4;
  EXPECT_EQ(error_of(changed), damaged);
  changed = bytes;
  changed[12] = 7;
  EXPECT_NE(error_of(changed).find("of version 7; this program reads version 1"), std::string::npos);
  EXPECT_FALSE(exists("a.svg"));
}

/// Of a file that was forged nothing is believed: every byte in turn, with the checksum made to fit.
TEST_F(CompileTest, ForgedFilesAreReadOrRefused) {
  for (const char* method : {"bsp", "convex-tree"}) {
    const std::string bytes = compiled((kScenes / "cyclic_4.json").string(), {"--method", method});
    expect_forgeries_are_refused(bytes, sign_compiled_model, read_compiled_model);
  }
}

}  // namespace
}  // namespace ligne::test
