/// Suggestive contours, ridges and valleys of `ligne draw`.

#include "draw_program.hpp"
#include "support/standard.hpp"

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
  EXPECT_EQ(strokes_by_class(drawn("ring.obj")).count("suggestive"), 0u);
  EXPECT_EQ(strokes_by_class(drawn("ring.obj --edges all")).count("suggestive"), 0u);
  for (const char* quality : {"clear", "exact"}) {
    auto seen = strokes_by_class(drawn({"ring.obj", "--edges", "outline,suggestive", "--quality", quality}));
    EXPECT_GT(seen["suggestive"], 0) << quality;
    EXPECT_GT(seen["outline"], 0) << quality;
  }
  expect_outcome("draw ring.obj --edges ridges -o x.svg", 2, {"suggestive, ridge, valley"});
  const Outcome flat = run_well({"draw", LIGNE_SOURCE_DIR "/tests/corpus/cube.json", "--edges",
                                 "outline,suggestive,ridge,valley", "--stats", "-o", "cube.svg"});
  EXPECT_EQ(contents(file("cube.svg")).find("suggestive"), std::string::npos);
  expect_parts(flat.err, {"lines of class ridge"});
}

TEST_F(ShapeLinesTest, HaveALayerAWidthAndAFaceOfTheirOwn) {
  write_torus(false);
  run_well("draw ring.obj --edges outline,suggestive -o a.svg");
  EXPECT_NE(contents(file("a.svg")).find("id=\"suggestive\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.245\""),
            std::string::npos);
  run_well("draw ring.obj --edges suggestive --width suggestive=0.6 -o b.svg");
  EXPECT_NE(contents(file("b.svg")).find("id=\"suggestive\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.6\""),
            std::string::npos);
  for (const json& s : drawn("ring.obj --edges suggestive")["strokes"]) {
    EXPECT_TRUE(s["source"]["edge"].is_null());
    EXPECT_LT(s["source"]["faces"][0].get<int>(), 90 * 45);
    EXPECT_TRUE(s["source"]["faces"][1].is_null());
  }
}

TEST_F(ShapeLinesTest, AreHiddenByWhatIsInFront) {
  write_torus(false);
  write_torus(true);
  const Words view = "--edges suggestive,border --direction -1,-0.8,-1 --hidden dashed --scale 1:1";
  const auto of = [&](const char* file) { return drawn(Words{file} + view); };
  const json free = of("ring.obj"), covered = of("covered.obj");
  EXPECT_GT(suggestive(free, true), 40);
  EXPECT_LT(suggestive(covered, true), 0.8 * suggestive(free, true));
  EXPECT_NEAR(suggestive(covered, true) + suggestive(covered, false), suggestive(free, true) + suggestive(free, false),
              0.02 * suggestive(free, true));
}

TEST_F(ShapeLinesTest, AreTheSameByAllMethodsAndForAnyNumberOfThreads) {
  write_torus(true);
  const Words view = "draw covered.obj --edges outline,suggestive,ridge,valley --direction -1,-0.8,-1 -q";
  const auto file_of = [&](const std::string& name, const Words& more) {
    run_well(view + more + Words{"-o", name});
    return contents(file(name));
  };
  const std::string one = file_of("one.svg", "--threads 1");
  for (const char* threads : {"2", "8"}) EXPECT_EQ(file_of("more.svg", {"--threads", threads}), one) << threads;
  const double length = suggestive(json::parse(file_of("a.json", "--method appel")), true);
  EXPECT_GT(length, 10);
  for (const char* method : {"warnock", "watkins", "atherton-weiler"}) {
    EXPECT_NEAR(suggestive(json::parse(file_of("m.json", {"--method", method})), true), length, 1e-2) << method;
  }
}

/// Clear lines beside those of the mesh: `--edges all`.

/// A ball as a scanner gives it: six square grids of n x n, blown up to a sphere, whose points are off it at random.
std::string scanned_ball(int n, double noise) {
  std::ostringstream points, faces;
  std::mt19937 random(3);
  std::map<std::array<int, 3>, int> numbers;
  const auto number_of = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<int>(numbers.size()) + 1);
    if (is_new) {
      const double x = 2.0 * at[0] / n - 1, y = 2.0 * at[1] / n - 1, z = 2.0 * at[2] / n - 1;
      const double off = noise * (double(random() % 2001) / 1000 - 1), r = (1 + off) / std::hypot(x, y, z);
      points << "v " << r * x << ' ' << r * y << ' ' << r * z << '\n';
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int a, int b) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = side == n ? i + a : i + b;
            at[(axis + 2) % 3] = side == n ? j + b : j + a;
            return number_of(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          faces << "f " << a << ' ' << b << ' ' << c << "\nf " << a << ' ' << c << ' ' << d << '\n';
        }
      }
    }
  }
  return points.str() + faces.str();
}

/// Visible lines of the class, mm.
double length_of(const json& drawing, const std::string& line_class) {
  double sum = 0;
  for (const json& s : drawing["strokes"]) {
    if (!s["visible"].get<bool>() || s["class"] != line_class) continue;
    const auto a = s["points"][0].get<std::array<double, 2>>(), b = s["points"][1].get<std::array<double, 2>>();
    sum += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  return sum;
}

/// Where an outline passes from face to face, lines of the mesh end at every corner: it is no bundle of spurs for that.
TEST_F(DrawTest, OutlinesOfScansStayWhereTheMeshIsDrawn) {
  write("ball.obj", scanned_ball(24, 0.005));
  const double alone = length_of(drawn("ball.obj"), "outline");
  const json with_mesh = drawn("ball.obj --edges all");
  EXPECT_GT(alone, 2 * std::numbers::pi * 90) << "at least the round of the ball, which fills the sheet's width";
  EXPECT_GT(length_of(with_mesh, "outline"), alone);
  EXPECT_GT(length_of(with_mesh, "mesh"), 10 * alone);
}

}  // namespace
}  // namespace ligne::test
