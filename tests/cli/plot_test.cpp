/// ligne plot, ligne devices, and the plotter's options of the other commands, as a user runs them.

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class PlotTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const Words& arguments) const {
    const Outcome outcome = run_well(arguments + Words{"-o", name});
    return outcome.status == 0 ? contents(file(name)) : "";
  }
};

TEST_F(PlotTest, CurvesWhereThePenArrives) {
  write("round.svg",
        "<svg width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'><circle cx='70' cy='40' r='8'/>"
        "<path d='M20 10l8.66 5v10l-8.66 5l-8.66-5v-10z'/><circle cx='30' cy='40' r='5'/></svg>");
  const auto begins = [&](const std::string& svg) {
    std::vector<std::string> starts;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      starts.push_back(svg.substr(at + 4, svg.find_first_of("cClLZ", at + 4) - at - 4));
    return starts;
  };
  const auto curved_paths = [](const std::string& svg) {
    int count = 0;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      count += svg.substr(at + 3, svg.find('"', at + 3) - at - 3).find_first_of("cC") != std::string::npos;
    return count;
  };
  for (const std::string optimize : {"join", "full"}) {
    const Words command{"plot", "round.svg", "--pen", "rest=1,black,0.3", "--optimize", optimize};
    Words curved = command + "--curves on";
    const std::string lines = written("l.svg", command), curves = written("c.svg", curved);
    EXPECT_EQ(begins(lines).size(), 3u);
    EXPECT_EQ(begins(curves), begins(lines)) << curves;
    EXPECT_LT(curves.size() * 2, lines.size());
    EXPECT_EQ(curved_paths(curves), 2) << "not the hexagon: " << curves;
    EXPECT_EQ(curved_paths(lines), 0);
  }
  EXPECT_LT(written("plain.svg", "plot round.svg --curves on").size() * 2, written("plain-l.svg", "plot round.svg").size());
}

TEST_F(PlotTest, WhatIsResumedIsTheEndOfTheWhole) {
  write(
      "a.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'>\n"
      "<path d='M10 10H50'/><path d='M10 20H50'/><path d='M10 30H50' stroke='red'/><path d='M10 40H50' stroke='red'/></svg>");
  const auto made = [&](const Words& arguments) { run_well("plot" + arguments); };
  made("a.svg -o whole.gcode");
  made("a.svg --from-stroke 3 -o rest.gcode");
  const std::string whole = contents(file("whole.gcode")), rest = contents(file("rest.gcode"));
  EXPECT_EQ(count_of(rest, "M3 S90"), 2u);
  const std::string strokes = rest.substr(rest.find("G0 X"));
  EXPECT_TRUE(whole.ends_with(strokes));
  // The first stroke takes 22 mm of way, a lift and 40 mm of line: 1.5 s; the second is drawn at that time.
  made("a.svg --from-time 2s -o rest.gcode");
  EXPECT_EQ(count_of(contents(file("rest.gcode")), "M3 S90"), 3u);
  expect_error("plot a.svg --from-time soon -o a.gcode", kUsage,
               "ligne: --from-time: \"soon\" is not a time such as 90s, 30min, 2h or 12:30\n");
}

TEST_F(PlotTest, BrokenStoredOrdersAreRefused) {
  ASSERT_NE(written("stored.json", {"draw", LIGNE_SOURCE_DIR "/tests/corpus/bricks.json", "--method", "newell", "-q"}), "");
  const auto refused = [&](const Words& arguments, const std::string& part) {
    expect_outcome(arguments + Words("-o x.svg"), kFailed, {part});
    EXPECT_FALSE(exists("x.svg"));
  };
  json broken = json::parse(contents(file("stored.json")));
  broken["order"][0]["material"] = 7;
  write("broken.json", broken.dump());
  refused("plot broken.json --fill material", "a piece of the order has a missing material");
  broken["order"][0].erase("material");
  write("older.json", broken.dump());
  refused("plot older.json --fill material", "piece 0 of the order: has no material; draw it again");
  broken["order"][0]["outer"] = json::array();
  write("empty.json", broken.dump());
  refused("plot empty.json --fill material", "piece 0 of the order: a contour has fewer than three points");
}

}  // namespace
}  // namespace ligne::test
