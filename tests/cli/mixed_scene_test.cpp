/// Surfaces among the models of `ligne draw`.

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class MixedSceneTest : public SurfaceProgramTest {
 protected:
  /// A box of 2 x 2 from z = -1 to 1 round the origin.
  void write_box(const std::string& name, bool y_up) const {
    std::string obj;
    for (const int z : {-1, 1}) {
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        obj += "v " + std::to_string(x) + " " + std::to_string(y_up ? z : y) + " " + std::to_string(y_up ? -y : z) + "\n";
      }
    }
    write(name, obj + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  }
  json mixed(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "draw");
    arguments.insert(arguments.end(), {"-o", "-", "--format", "json"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
};

TEST_F(MixedSceneTest, CurvesAndModelsHideEachOtherAndMeetInAFootLine) {
  // A box that stands half in a plane of 6 x 6, seen from above: its top hides 2 x 2 of the plane's curves.
  for (const bool y_up : {false, true}) {
    write_box("box.obj", y_up);
    const std::vector<std::string> scene{"box.obj",   "--surface",     "0", "-x", "-3:3:7", "-y", "-3:3:7",
                                         "--up-axis", y_up ? "y" : "z"};
    std::vector<std::string> top = scene, front = scene;
    top.insert(top.end(), {"--view", "top", "--quality", "exact"});
    const json above = mixed(top);
    EXPECT_NEAR(length(above, "horizon"), 14 * 6 - 2 * 2 - 8, 1e-3)
        << "the curves below the box and its outline are not seen";
    EXPECT_NEAR(length(above, "outline") + length(above, "crease"), 8, 1e-3);
    // From the front and above the foot line is seen on two sides of four.
    front.insert(front.end(), {"--view", "iso"});
    const json iso = mixed(front);
    EXPECT_GT(length(iso, "intersection"), 1);
    EXPECT_GT(length(iso, "horizon"), 30);
  }
}

TEST_F(MixedSceneTest, FormulasTakeTheGroundOfTheModels) {
  write_box("box.obj", false);
  const json above = mixed({"box.obj", "--up-axis", "z", "--surface", "5", "--view", "top"});
  // The box's outline lies under the rim of the surface, and stands for it.
  EXPECT_NEAR(length(above, "horizon") + length(above, "outline"), 80 * 2, 1e-3);
  EXPECT_EQ(length(above, "crease"), 0);
}

TEST_F(MixedSceneTest, Mistakes) {
  write_box("box.obj", false);
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& message) {
    arguments.insert(arguments.begin(), {"draw", "box.obj"});
    arguments.insert(arguments.end(), {"-o", "a.svg"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: " + message, 0), 0u) << outcome.err;
  };
  refused({"-x", "0:1"}, 2, "-x, -y, --samples, --every, --z-scale, --z-range: go with --surface or --grid");
  refused({"--surface", "foo(x)"}, 1, "formula:1: unknown function 'foo'");
  refused({"--grid", "absent.csv"}, 1, "absent.csv: ");
}

}  // namespace
}  // namespace ligne::test
