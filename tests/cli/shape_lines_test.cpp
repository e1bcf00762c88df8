/// Suggestive contours, ridges and valleys of `ligne draw`.

#include <cmath>
#include <set>
#include <sstream>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

class ShapeLinesTest : public DrawTest {
 protected:
  /// A lying torus as an OBJ; with a plate before a half of it.
  void write_torus(bool with_plate) const {
    std::ostringstream obj;
    obj.precision(9);
    const int columns = 90, rows = 45;
    obj << "o ring\n";
    for (int i = 0; i < columns; ++i) {
      for (int k = 0; k < rows; ++k) {
        const double u = 2 * kPi * i / columns, v = 2 * kPi * k / rows, r = 60 + 25 * std::cos(v);
        obj << "v " << r * std::cos(u) << ' ' << 25 * std::sin(v) << ' ' << r * std::sin(u) << '\n';
      }
    }
    for (int i = 0; i < columns; ++i) {
      for (int k = 0; k < rows; ++k) {
        const int a = i * rows + k, b = (i + 1) % columns * rows + k, c = (i + 1) % columns * rows + (k + 1) % rows,
                  d = i * rows + (k + 1) % rows;
        obj << "f " << a + 1 << ' ' << d + 1 << ' ' << c + 1 << ' ' << b + 1 << '\n';
      }
    }
    if (with_plate) {
      const int first = columns * rows + 1;
      obj << "o plate\nv 150 20 150\nv 150 220 150\nv 270 220 30\nv 270 20 30\n";
      obj << "f " << first << ' ' << first + 1 << ' ' << first + 2 << ' ' << first + 3 << '\n';
    }
    write(with_plate ? "covered.obj" : "ring.obj", obj.str());
  }

  /// Length of the strokes of class suggestive that are seen, or hidden, mm.
  static double suggestive(const json& drawing, bool visible) {
    double sum = 0;
    for (const json& s : drawing["strokes"]) {
      if (s["class"] != "suggestive" || s["visible"].get<bool>() != visible) continue;
      sum += std::hypot(s["points"][1][0].get<double>() - s["points"][0][0].get<double>(),
                        s["points"][1][1].get<double>() - s["points"][0][1].get<double>());
    }
    return sum;
  }
};

TEST_F(ShapeLinesTest, AreDrawnWhereTheyAreAskedFor) {
  write_torus(false);
  EXPECT_EQ(strokes_by_class(drawn({"ring.obj"})).count("suggestive"), 0u);
  EXPECT_EQ(strokes_by_class(drawn({"ring.obj", "--edges", "all"})).count("suggestive"), 0u);
  for (const char* quality : {"clear", "exact"}) {
    auto seen = strokes_by_class(drawn({"ring.obj", "--edges", "outline,suggestive", "--quality", quality}));
    EXPECT_GT(seen["suggestive"], 0) << quality;
    EXPECT_GT(seen["outline"], 0) << quality;
  }
  const Outcome wrong = run({"draw", "ring.obj", "--edges", "ridges", "-o", "x.svg"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("suggestive, ridge, valley"), std::string::npos) << wrong.err;
  const Outcome flat = run({"draw", LIGNE_SOURCE_DIR "/tests/corpus/cube.json", "--edges", "outline,suggestive,ridge,valley",
                            "--stats", "-o", "cube.svg"});
  EXPECT_EQ(flat.status, 0);
  EXPECT_EQ(contents(file("cube.svg")).find("suggestive"), std::string::npos);
  EXPECT_NE(flat.err.find("lines of class ridge"), std::string::npos) << flat.err;
}

TEST_F(ShapeLinesTest, HaveALayerAWidthAndAFaceOfTheirOwn) {
  write_torus(false);
  ASSERT_EQ(run({"draw", "ring.obj", "--edges", "outline,suggestive", "-o", "a.svg"}).status, 0);
  EXPECT_NE(contents(file("a.svg")).find("id=\"suggestive\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.245\""),
            std::string::npos);
  ASSERT_EQ(run({"draw", "ring.obj", "--edges", "suggestive", "--width", "suggestive=0.6", "-o", "b.svg"}).status, 0);
  EXPECT_NE(contents(file("b.svg")).find("id=\"suggestive\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.6\""),
            std::string::npos);
  for (const json& s : drawn({"ring.obj", "--edges", "suggestive"})["strokes"]) {
    EXPECT_TRUE(s["source"]["edge"].is_null());
    EXPECT_LT(s["source"]["faces"][0].get<int>(), 90 * 45);
    EXPECT_TRUE(s["source"]["faces"][1].is_null());
  }
}

TEST_F(ShapeLinesTest, AreHiddenByWhatIsInFront) {
  write_torus(false);
  write_torus(true);
  const std::vector<std::string> view{"--edges", "suggestive,border", "--direction", "-1,-0.8,-1", "--hidden",
                                      "dashed",  "--scale",           "1:1"};
  const auto of = [&](const char* file) {
    std::vector<std::string> arguments{file};
    arguments.insert(arguments.end(), view.begin(), view.end());
    return drawn(arguments);
  };
  const json free = of("ring.obj"), covered = of("covered.obj");
  EXPECT_GT(suggestive(free, true), 40);
  EXPECT_LT(suggestive(covered, true), 0.8 * suggestive(free, true));
  EXPECT_NEAR(suggestive(covered, true) + suggestive(covered, false), suggestive(free, true) + suggestive(free, false),
              0.02 * suggestive(free, true));
}

TEST_F(ShapeLinesTest, AreTheSameByAllMethodsAndForAnyNumberOfThreads) {
  write_torus(true);
  const std::vector<std::string> view{"draw",        "covered.obj", "--edges", "outline,suggestive,ridge,valley",
                                      "--direction", "-1,-0.8,-1",  "-q"};
  const auto file_of = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = view;
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"-o", name});
    EXPECT_EQ(run(arguments).status, 0);
    return contents(file(name));
  };
  const std::string one = file_of("one.svg", {"--threads", "1"});
  for (const char* threads : {"2", "8"}) EXPECT_EQ(file_of("more.svg", {"--threads", threads}), one) << threads;
  const double length = suggestive(json::parse(file_of("a.json", {"--method", "appel"})), true);
  EXPECT_GT(length, 10);
  for (const char* method : {"warnock", "watkins", "atherton-weiler"}) {
    EXPECT_NEAR(suggestive(json::parse(file_of("m.json", {"--method", method})), true), length, 1e-2) << method;
  }
}

}  // namespace
}  // namespace ligne::test
