/// Mistakes of people who do not know the program yet: help, names that are nearly right, files in place of commands.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class MistakesOfNewcomers : public DrawTest {
 protected:
  void says(const Words& arguments, const std::string& line) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, kUsage) << line;
    EXPECT_EQ(outcome.err, "ligne: " + line + "\n");
  }

  /// Standard input is what stands in a file, through a pipe.
  Outcome run_with_input(const std::string& bytes, const Words& arguments) const {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    EXPECT_EQ(write_all(ends[1], bytes), bytes.size());
    close(ends[1]);
    const int before = dup(STDIN_FILENO);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    const Outcome outcome = run(arguments);
    dup2(before, STDIN_FILENO);
    close(before);
    return outcome;
  }

 private:
  static std::size_t write_all(int descriptor, const std::string& bytes) {
    return static_cast<std::size_t>(::write(descriptor, bytes.data(), bytes.size()));
  }
};

TEST_F(MistakesOfNewcomers, HelpIsACommandToo) {
  const Outcome all = run("--help");
  EXPECT_EQ(run("help").out, all.out);
  for (const char* command : {"draw", "surface", "plot", "compile", "info", "compare", "methods", "devices", "study"}) {
    const Outcome help = run_well({"help", command});
    EXPECT_EQ(help.out, run({command, "--help"}).out);
    EXPECT_NE(help.out.find(command), std::string::npos);
  }
  const Outcome common = run("draw --help"), every = run("help draw all");
  EXPECT_EQ(run("draw --help all").out, every.out);
  EXPECT_LT(std::ranges::count(common.out, '\n'), 90) << "more than a page and a half";
  for (const std::string_view option : {"--edges ", "--output ", "--hidden "}) {
    EXPECT_NE(common.out.find(option), std::string::npos) << option;
  }
  EXPECT_EQ(common.out.find("--zbuffer-save "), std::string::npos);
  EXPECT_NE(every.out.find("--zbuffer-save "), std::string::npos);
  EXPECT_EQ(every.out.find("depth-bits"), std::string::npos) << "settings for experiments stand in the lists of methods";
  EXPECT_NE(output_of("methods zbuffer").find("--set depth-bits=N"), std::string::npos);
  EXPECT_NE(common.out.find("more options: ligne help draw all\n"), std::string::npos);
  EXPECT_EQ(run("help drwa").err.rfind("ligne: help: there is no command \"drwa\" (draw?); there are draw, ", 0), 0u);
  says("help draw plot", "help: one command at a time: ligne help COMMAND");
}

TEST_F(MistakesOfNewcomers, OptionsThatAreNearlyRight) {
  says("draw --hlep", "unknown: --hlep (--help?); see ligne draw --help");
  says("draw --depth-bits 4", "unknown: --depth-bits (--set depth-bits=VALUE?); see ligne draw --help");
  expect_outcome("draw cube.obj --set depthbits=4 -o a.svg", kUsage,
                 {"--set: \"depthbits\" is not one of propagate, ", "candidates, partition, filling, ", "(depth-bits?)"});
  says("draw cube.obj --set depth-bits -o a.svg", "--set: \"depth-bits\" is not NAME=VALUE");
  says("info --jsno", "unknown: --jsno (--json?); see ligne info --help");
  says(
      "draw cube.obj --view isometric -o a.svg",
      "--view: \"isometric\" is not one of front, back, left, right, top, bottom, iso, dimetric, trimetric or camera (iso?)");
  says("draw cube.obj --edges outlines -o a.svg",
       "--edges: \"outlines\" is not one of outline, border, intersection, crease, tangent, mesh, profile, shadow, "
       "suggestive, ridge, valley, detail, feature or all (outline?)");
}

TEST_F(MistakesOfNewcomers, DevicesThatAreNearlyRight) {
  const Outcome many = run("draw cube.obj --device axidraw -o a.svg");
  EXPECT_EQ(many.status, kUsage);
  EXPECT_EQ(many.err.rfind("ligne: --device: \"axidraw\" is not known (axidraw-", 0), 0u) << many.err;
  EXPECT_NE(many.err.find("axidraw-v3"), std::string::npos) << many.err;
  says("draw cube.obj --device hp7475 -o a.plt", "--device: \"hp7475\" is not known (hp7475a?); ligne devices lists them");
}

TEST_F(MistakesOfNewcomers, AFileInPlaceOfACommand) {
  says("gear.json", "there is no command gear.json; for a file: ligne draw gear.json -o FILE");
  says("'a b.SVG'", "there is no command a b.SVG; for a file: ligne plot a b.SVG -o FILE");
  says("terrain.asc -o a.svg", "there is no command terrain.asc; for a file: ligne surface --grid terrain.asc -o FILE");
}

TEST_F(MistakesOfNewcomers, UnitsOfMovesAreAllNamed) {
  says("draw cube.obj --move cube=0,0,1px -o a.svg",
       "--move: \"1px\" is neither a number of model units nor a length in mm, cm, m, in or pt");
}

TEST_F(MistakesOfNewcomers, FormatsAgainstTheirSuffix) {
  const Outcome png = run_well("draw cube.obj --format png -o a.svg");
  EXPECT_EQ(png.err, "ligne: a.svg: warning: is written as png (--format), though its name is that of svg\n");
  EXPECT_EQ(contents(file("a.svg")).substr(1, 3), "PNG");
  EXPECT_EQ(run("surface x*y --format pdf -o a.svg").error_lines(), 1u);
  EXPECT_EQ(run("draw cube.obj --format svg -o drawing").err, "");
  EXPECT_EQ(run("draw cube.obj --format hpgl -o a.plt").err, "");
}

TEST_F(MistakesOfNewcomers, StandardInputIsAModel) {
  const std::string expected = contents(file("cube.obj"));
  const Outcome named = run("draw cube.obj -o - --format json");
  const Outcome piped = run_with_input(expected, "draw - -o - --format json");
  EXPECT_EQ(piped.status, kDone) << piped.err;
  EXPECT_EQ(json::parse(piped.out)["strokes"].size(), json::parse(named.out)["strokes"].size());
  const Outcome info = run_with_input(expected, "info -");
  EXPECT_EQ(info.out.substr(0, 15), "standard input\n") << info.err;
  EXPECT_EQ(run_with_input("", "draw - -o a.svg").err, "ligne: standard input: is empty\n");
  EXPECT_EQ(run_with_input("v 0 0 0\nf 1 2 9\n", "draw - -o a.svg").err.rfind("ligne: standard input:2: ", 0), 0u);
}

TEST_F(MistakesOfNewcomers, NamesAreEscapedWhereverTheyArePrinted) {
  const std::string bad = "x\x1b]0;pwn\a\x9b.obj";
  std::filesystem::copy_file(file("cube.obj"), file(bad));
  for (const Words& arguments : {Words{"info", bad},
                                 {"draw", bad, "-o", "a.svg", "--stats", "--report"},
                                 {"draw", bad, "--dpi", "99", "-o", bad + ".svg"},
                                 {"draw", bad, "--format", "png", "-o", bad + ".svg"},
                                 {"draw", bad + ".stl", "-o", "a.svg"},
                                 {"compare", bad, "--methods", "appel"},
                                 {"help", bad},
                                 {bad},
                                 {"plot", bad, "-o", "a.svg"},
                                 {"surface", "--grid", bad, "-o", "a.svg"},
                                 {"study", bad},
                                 {"draw", "cube.obj", bad},
                                 {"draw", "cube.obj", "--device", bad, "-o", "a.svg"},
                                 {"draw", "cube.obj", "--view", bad, "-o", "a.svg"},
                                 {"draw", "cube.obj", "-o", bad},
                                 {"compile", bad, "-o", "a.tree", "--stats"}}) {
    const Outcome outcome = run(arguments);
    for (const std::string& text : {outcome.out, outcome.err}) {
      EXPECT_EQ(text.find('\x1b'), std::string::npos) << arguments[0];
      EXPECT_EQ(text.find('\a'), std::string::npos) << arguments[0];
      EXPECT_EQ(text.find('\x9b'), std::string::npos) << arguments[0];
    }
  }
  EXPECT_EQ(run({"info", bad}).out.rfind("x\\x1b]0;pwn\\x07\\x9b.obj\n", 0), 0u);
}

TEST_F(MistakesOfNewcomers, PagesThatReadersOfPdfDoNotShow) {
  const Outcome large = run_well("draw cube.obj --page 10000x10000 -o p.pdf");
  EXPECT_EQ(
      large.err,
      "ligne: cube.obj: warning: a page of 10000 x 10000 mm is larger than the 14400 points (5080 mm) that readers of PDF "
      "show; write an SVG, which ligne plot --tile A0 cuts into pages\n");
  EXPECT_EQ(run("draw cube.obj --page 5080x5080 -o p.pdf").err, "");
  EXPECT_EQ(run("draw cube.obj --page 10000x10000 -o p.svg").err, "");
  EXPECT_EQ(run("plot p.svg --tile A0 -o p.pdf").err, "");
}

}  // namespace
}  // namespace ligne::test
