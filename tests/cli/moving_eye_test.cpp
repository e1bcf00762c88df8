/// ligne draw --to and --path: successive views of an eye that moves.

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class MovingEyeTest : public DrawTest {
 protected:
  json frame(const std::string& name) const { return json::parse(contents(file(name))); }
};

const std::string kTower = LIGNE_SOURCE_DIR "/examples/models/stair-tower.obj",
                  kBricks = LIGNE_SOURCE_DIR "/tests/corpus/bricks.json";

/// Edges with the visible parts of them, to a ten-thousandth.
std::set<std::string> visible_parts(const json& drawing) {
  std::set<std::string> parts;
  for (const json& s : drawing["strokes"]) {
    const json edge = s["source"]["edge"];
    if (edge.is_null()) continue;
    char text[80];
    std::snprintf(text, sizeof text, "%d %.4f %.4f", edge.get<int>(), s["interval"][0].get<double>(),
                  s["interval"][1].get<double>());
    parts.insert(text);
  }
  return parts;
}

/// Every frame shows what a view of its own shows from the same place, by every method that keeps something.
TEST_F(MovingEyeTest, FramesAreViewsOfTheirOwn) {
  for (const char* method : {"appel", "newell", "bsp", "convex-tree"}) {
    const Words study{"draw", kBricks, "--quality", "exact", "--method", method};
    run_well(study + "--eye 30,-40,30 --to -30,-40,10 --frames 3 -o to%d.json");
    const char* const eyes[] = {"30,-40,30", "0,-40,20", "-30,-40,10"};
    for (int i = 0; i < 3; ++i) {
      const json alone = json::parse(run(study + Words{"--eye", eyes[i], "-o", "-", "--format", "json"}).out);
      const json moved = frame("to" + std::to_string(i + 1) + ".json");
      EXPECT_EQ(visible_parts(moved), visible_parts(alone)) << method << ", " << eyes[i];
      EXPECT_GT(visible_parts(moved).size(), 10u);
    }
  }
}

/// The frames of a path stand equally far apart on it, and look along it.
TEST_F(MovingEyeTest, APathIsWalkedAtOneSpeed) {
  write("way.csv", "x,y,z\n10,-40,5\n10,-20,5\n");
  run_well(
      {"draw", kBricks, "--quality", "exact", "--eye", "0,-40,5", "--path", "way.csv", "--frames", "4", "-o", "p%d.json"});
  // A way of 10 + 20 in three steps: 0, 10, 20 and 30 from its beginning; at the bend it still looks along the first part.
  const char* const views[] = {"--eye 0,-40,5 --target 1,-40,5", "--eye 10,-40,5 --target 11,-40,5",
                               "--eye 10,-30,5 --target 10,-29,5", "--eye 10,-20,5 --target 10,-19,5"};
  for (int i = 0; i < 4; ++i) {
    const json alone =
        json::parse(run(Words{"draw", kBricks, "-q", "--quality", "exact"} + Words(views[i]) + "-o - --format json").out);
    EXPECT_EQ(visible_parts(frame("p" + std::to_string(i + 1) + ".json")), visible_parts(alone)) << views[i];
  }
}

}  // namespace
}  // namespace ligne::test
