/// The command `ligne surface`.

#include <regex>

#include "program.hpp"

namespace ligne::test {
namespace {

class SurfaceTest : public ProgramTest {
 protected:
  std::string svg(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "surface");
    arguments.insert(arguments.end(), {"-o", "-", "--format", "svg"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  std::size_t paths(const std::vector<std::string>& arguments) const {
    const std::string text = svg(arguments);
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find("<path", at)) != std::string::npos; ++at) ++n;
    return n;
  }
  void fails(const std::vector<std::string>& arguments, int status, const std::string& message) const {
    std::vector<std::string> all{"surface"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: " + message, 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
};

TEST_F(SurfaceTest, DrawsAFormulaInTheLayerHorizon) {
  const std::string text = svg({"x*y", "-x", "0:1:5", "-y", "0:1:7"});
  EXPECT_NE(text.find("id=\"horizon\""), std::string::npos);
}

TEST_F(SurfaceTest, NumbersOfCurves) {
  const std::vector<std::string> flat{"0", "-x", "0:1:5", "-y", "0:2:7"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), flat.begin(), flat.end());
    return paths(more);
  };
  EXPECT_EQ(with({}), 12u);
  EXPECT_EQ(with({"--lines", "x"}), 5u);
  EXPECT_EQ(with({"--lines", "y"}), 7u);
  EXPECT_EQ(with({"--samples", "100"}), 12u);
  EXPECT_EQ(with({"--eye", "0.3,0.7,4", "--fov", "90"}), 12u + 5 + 7) << "the eye over the ground divides the curves";
}

TEST_F(SurfaceTest, GridsAndTheirCurves) {
  write("flat.csv", "1,1,1,1,1\n1,1,1,1,1\n1,1,1,1,1\n1,1,1,1,1\n");
  EXPECT_EQ(paths({"--grid", "flat.csv"}), 9u);
  EXPECT_EQ(paths({"--grid", "flat.csv", "--every", "3"}), 3u + 2u);  // columns 0, 3, 4 and rows 0, 3
}

TEST_F(SurfaceTest, HiddenPartsAreLeftOut) {
  // A wall before a plain, looked at from low in front: the plain behind it is not seen.
  const std::vector<std::string> wall{"if(y < 0.25, 1, 0)", "-x", "0:1:4", "-y", "0:1:5", "--lines", "y", "--z-scale", "1", "--azimuth", "-90"};
  const auto with = [&](const char* elevation) {
    std::vector<std::string> all = wall;
    all.insert(all.end(), {"--elevation", elevation});
    return paths(all);
  };
  EXPECT_EQ(with("0"), 2u) << "the top of the wall, and the plain's level below it, once";
  EXPECT_EQ(with("80"), 5u);
}

TEST_F(SurfaceTest, ThreadsAndHorizons) {
  const std::vector<std::string> sombrero{"sin(r)/r", "-x", "-9:9:60", "-y", "-9:9:60"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), sombrero.begin(), sombrero.end());
    return svg(more);
  };
  EXPECT_EQ(with({"--threads", "1"}), with({"--threads", "4"}));
  EXPECT_NE(with({"--horizon", "pixels", "--resolution", "300"}), with({}));
}

TEST_F(SurfaceTest, Mistakes) {
  fails({"-o", "a.svg"}, 2, "surface: give a formula in x and y, or --grid FILE");
  fails({"x+", "-o", "a.svg"}, 1, "formula:");
  fails({"x", "-x", "3:1", "-o", "a.svg"}, 2, "-x: the range 3:1 does not ascend");
  fails({"x", "-x", "0:1:1", "-o", "a.svg"}, 2, "-x: ");
  fails({"x", "-x", "0:1:1000000000", "-o", "a.svg"}, 2, "-x: ");
  fails({"x", "-x", "0", "-o", "a.svg"}, 2, "-x: \"0\" is not A:B or A:B:N");
  fails({"x", "--every", "2", "-o", "a.svg"}, 2, "--every: ");
  fails({"x", "--resolution", "2", "-o", "a.svg"}, 2, "--resolution: ");
  fails({"x", "--azimuth", "2", "--view", "top", "-o", "a.svg"}, 2, "--azimuth, --elevation: ");
  fails({"--grid", "nowhere.csv", "-o", "a.svg"}, 1, "nowhere.csv: ");
  fails({"sqrt(-1-r)", "-o", "a.svg"}, 0, "surface: warning: nothing to draw is in view");
}

}  // namespace
}  // namespace ligne::test
