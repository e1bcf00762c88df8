/// ligne plot: parts, resuming, files of pens, sheets, several drawings, as a user runs them.

#include <filesystem>

#include "program.hpp"

namespace ligne::test {
namespace {

constexpr const char* kFourLinesSvg =
    "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'>\n"
    "<path d='M10 10H50'/><path d='M10 20H50'/><path d='M10 30H50' stroke='red'/><path d='M10 40H50' "
    "stroke='red'/>\n</svg>\n";

class LongPlotTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("a.svg", kFourLinesSvg);
  }

  void made(const Words& arguments) const { run_well("plot" + arguments); }
  void refused(const Words& arguments, const std::string& message) const {
    const Outcome outcome = run("plot" + arguments);
    EXPECT_EQ(outcome.status, 2) << message;
    EXPECT_EQ(outcome.err, "ligne: " + message + "\n");
  }
  bool there(const std::string& name) const { return std::filesystem::exists(file(name)); }
};

TEST_F(LongPlotTest, PartsAsFilesAndAsPauses) {
  made("a.svg --split lifts=3 -o part%02d.gcode");
  EXPECT_EQ(count_of(contents(file("part01.gcode")), "M3 S90"), 3u);
  EXPECT_EQ(count_of(contents(file("part02.gcode")), "M3 S90"), 1u);
  EXPECT_FALSE(there("part03.gcode"));
  made("a.svg --split distance=8cm -o a.gcode");
  EXPECT_EQ(count_of(contents(file("a.gcode")), "M0\n"), 1u);
  EXPECT_EQ(count_of(contents(file("a.gcode")), "M3 S90"), 4u);
  made("a.svg --split time=3s -o a.gcode");
  EXPECT_EQ(count_of(contents(file("a.gcode")), "M0\n"), 1u) << "a stroke takes 1.25 s, and its way";
  refused("a.svg --split lifts=3 -o a.plt", "--split: device cutter has no action \"pause\"; it has none");
  refused("a.svg --split lifts=3 -o a%d.svg",
          "--split, --every, --from-stroke, --from-time, --park and %p need pens or a --device");
  refused("a.svg --split lots -o a.plt", "--split: is not time=N, distance=N or lifts=N");
}

TEST_F(LongPlotTest, NothingIsLeftBehindTheLastStroke) {
  made("a.svg --from-stroke 4 -o rest.gcode");
  refused("a.svg --from-stroke 5 -o x.gcode", "--from-stroke: the plot has 4 strokes");
  refused("a.svg --from-stroke 99999 -o x.hpgl", "--from-stroke: the plot has 4 strokes");
  refused("a.svg --from-time 1h -o x.gcode", "--from-time: the plot has 4 strokes, all drawn by then");
  EXPECT_FALSE(there("x.gcode"));
}

TEST_F(LongPlotTest, WhatIsResumedIsTheEndOfTheWhole) {
  made("a.svg -o whole.gcode");
  made("a.svg --from-stroke 3 -o rest.gcode");
  const std::string whole = contents(file("whole.gcode")), rest = contents(file("rest.gcode"));
  EXPECT_EQ(count_of(rest, "M3 S90"), 2u);
  const std::string strokes = rest.substr(rest.find("G0 X"));
  EXPECT_TRUE(whole.ends_with(strokes));
  // The first stroke takes 22 mm of way, a lift and 40 mm of line: 1.5 s; the second is drawn at that time.
  made("a.svg --from-time 2s -o rest.gcode");
  EXPECT_EQ(count_of(contents(file("rest.gcode")), "M3 S90"), 3u);
  refused("a.svg --from-time soon -o a.gcode", "--from-time: \"soon\" is not a time such as 90s, 30min, 2h or 12:30");
}

TEST_F(LongPlotTest, ABrushIsDipped) {
  made("a.svg --every 0.1m --do dip -o a.gcode");
  // 160 mm: at the beginning and once more, in the middle of a stroke.
  EXPECT_EQ(count_of(contents(file("a.gcode")), "G4 P1\n"), 2u);
  EXPECT_EQ(count_of(contents(file("a.gcode")), "M3 S90"), 4u + 1 + 2);
  refused("a.svg --every 3m --do wash -o a.gcode", "--do: device grbl-servo has no action \"wash\"; it has dip, pause");
}

TEST_F(LongPlotTest, AFileForEachPen) {
  made("a.svg --pen #ff0000=2,red --pen rest=1 -o pen%p.gcode");
  EXPECT_EQ(count_of(contents(file("pen1.gcode")), "M3 S90"), 2u);
  EXPECT_EQ(count_of(contents(file("pen2.gcode")), "M3 S90"), 2u);
  EXPECT_EQ(count_of(contents(file("pen2.gcode")), "M0"), 0u);
  made("a.svg --pen #ff0000=2,red --pen rest=1 --split lifts=1 -o pen%p-%d.gcode");
  for (const char* name : {"pen1-1.gcode", "pen1-2.gcode", "pen2-3.gcode", "pen2-4.gcode"}) EXPECT_TRUE(there(name)) << name;
  made("a.svg --pen #ff0000=2,red --pen rest=1 --park home -o parked.gcode");
  EXPECT_NE(contents(file("parked.gcode")).find("G0 X0 Y0\nM0 (pen 2"), std::string::npos);
  refused("a.svg --park garage -o a.gcode", "--park: device grbl-servo has no place \"garage\"; it has home");
}

TEST_F(LongPlotTest, LargeDrawingsOnSeveralSheets) {
  made("a.svg --scale 8:1 --tile A4 --landscape -o sheet%d.svg");
  // 800 x 480 mm on sheets of 277 x 190 mm with 5 mm in common: three by three; the last column is empty.
  EXPECT_TRUE(there("sheet1.svg"));
  EXPECT_FALSE(there("sheet3.svg"));
  EXPECT_NE(contents(file("sheet1.svg")).find("width=\"297mm\" height=\"210mm\""), std::string::npos);
  EXPECT_NE(contents(file("sheet1.svg")).find("id=\"register\""), std::string::npos);
  made("a.svg --scale 8:1 --tile A4 -o sheets.pdf");
  refused("a.svg --scale 8:1 --tile A4 -o sheet.svg",
          "--output: several sheets need a number in the file name, such as name%d, or a PDF");
  refused("a.svg --tile A6 --margin 4cm --overlap 3cm -o sheet%d.svg",
          "--overlap: 30 mm and the margins leave no drawable area on the paper");
}

TEST_F(LongPlotTest, SeveralDrawingsOnOneSheet) {
  made("a.svg a.svg a.svg --grid 2x2 --page 200x120 --margin 0 -o all.svg");
  const std::string all = contents(file("all.svg"));
  expect_parts(all, {"width=\"200mm\" height=\"120mm\""});
  EXPECT_EQ(count_of(all, "inkscape:label="), 2u) << "layers of one name are one";
  expect_parts(all, {"M110 10l", "M10 70l"});
  refused("a.svg a.svg -o all.svg", "several drawings need --grid CxR, such as 2x2, to share one sheet");
  refused("a.svg a.svg --grid 1x1 -o all.svg", "--grid: has 1 cells for 2 drawings");
}

}  // namespace
}  // namespace ligne::test
