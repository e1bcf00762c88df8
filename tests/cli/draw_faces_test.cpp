/// Options of `ligne draw` for faces: light, glass, fills, hatching, scan lines.

#include <cmath>

#include "draw_program.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

TEST_F(DrawTest, GlassAndLightGiveTheSameBytesForAnyNumberOfThreads) {
  const std::string scenes = LIGNE_SOURCE_DIR "/tests/atherton_weiler/scenes/",
                    models = LIGNE_SOURCE_DIR "/examples/models/";
  for (const std::string& model :
       {scenes + "shadow_glass.json", scenes + "transparent_three.json", models + "stair-tower.obj"}) {
    std::size_t turn = 0;
    for (const char* study : {"faces", "polygons", "silhouettes"}) {
      for (const Words more : {"--format json", "--format svg --fill shade", "--format svg --fill material --hatch shade"}) {
        if (!is_chosen("threads, " + model, turn++, 9)) continue;
        const auto bytes = [&](const char* threads) {
          return run(Words{"draw", model, "-q", "-o", "-", "--set", std::string("study=") + study, "--light=1,1,-2",
                           "--light=-1,2,-2", "--threads", threads} +
                     more)
              .out;
        };
        const std::string one = bytes("1");
        EXPECT_GT(one.size(), 1000u);
        EXPECT_EQ(one, bytes("2")) << model << ' ' << study << ' ' << more.back();
      }
    }
  }
}

/// The options of scan lines: the drawing is the same with every span method, the bytes with any number of threads, in every
/// form.
TEST_F(DrawTest, ScanLines) {
  const std::string model = LIGNE_SOURCE_DIR "/examples/models/stair-tower.obj";
  const auto bytes = [&](const Words& more, const char* format) {
    const Outcome outcome =
        run(Words{"draw", model, "-q", "-o", "-", "--format", format, "--method", "watkins", "--dpi", "40"} + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string exact = bytes({}, "svg");
  EXPECT_GT(exact.size(), 10000u);
  for (const char* kind : chosen("span methods", 2, {"merge", "stack", "box", "point", "remembered"}))
    EXPECT_EQ(bytes({"--set", std::string("span-method=") + kind}, "svg"), exact) << kind;
  EXPECT_EQ(bytes("--lines exact", "svg"), exact);
  for (const char* threads : chosen("scan lines", 3, {"1", "2", "7"})) {
    EXPECT_EQ(bytes({"--threads", threads}, "svg"), exact);
    using Form = std::pair<Words, const char*>;
    for (const auto& [form, format] :
         chosen("forms", 3, {Form{"--lines 600", "json"}, Form{"--shade", "png"}, Form{"--hatch shade", "svg"}})) {
      EXPECT_EQ(bytes(Words{"--threads", threads} + form, format), bytes(form, format));
    }
  }
}

TEST_F(DrawTest, SpansInJson) {
  const json cube = drawn("cube.obj --method watkins --lines 100 --landscape");
  const json& spans = cube["spans"];
  ASSERT_GT(spans.size(), 80u);
  double area = 0;
  for (const json& line : spans) {
    double x = 0;
    EXPECT_NEAR(line["y"].get<double>(), (line["line"].get<double>() + 0.5) * 2.1, 1e-9);
    for (const json& span : line["spans"]) {
      EXPECT_GE(span[0].get<double>(), x);
      EXPECT_GT(span[1].get<double>(), span[0].get<double>());
      x = span[1].get<double>();
      area += (span[1].get<double>() - span[0].get<double>()) * 2.1;
    }
  }
  // A cube seen along its diagonal is a regular hexagon, here 190 mm high between two corners.
  EXPECT_NEAR(area, 95 * 95 * 3 * std::sqrt(3) / 2, 150);
  EXPECT_FALSE(drawn("cube.obj --method watkins").contains("spans"));
}

class HatchTest : public DrawTest {
 protected:
  /// The length of the strokes that are drawn without lines, mm on the page.
  double hatched_mm(const std::string& model, const Words& more) {
    const Outcome outcome =
        run(Words{"draw", model, "-o", "hatched.svg", "--report", "--edges", "border", "-q", "--hatch"} + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(contents(file("hatched.svg")).find("id=\"hatch\""), std::string::npos);
    double down = 0;
    EXPECT_EQ(std::sscanf(outcome.err.substr(outcome.err.find("before")).c_str(), "before %*d %lf", &down), 1)
        << outcome.err;
    return down;
  }
};

/// One interface whatever is hatched: regions of two methods, spans of a third. What they draw is the same up to the
/// roundings of the methods.
TEST_F(HatchTest, IsTheSameByEveryMethod) {
  const auto length_of = [&](const Words& more) { return hatched_mm("cube.obj", more); };
  const std::vector<Words> ways{{"shade", "--view", "trimetric"},
                                {"plain", "--hatch-spacing", "3mm", "--hatch-cross", "--view", "trimetric"},
                                {"material", "--hatch-angle", "10", "--view", "dimetric"},
                                {"shade", "--hatch-levels", "continuous", "--hatch-angle", "face", "--view", "trimetric"},
                                {"shade", "--hatch-levels", "2", "--eye", "60,-80,50"}};
  std::vector<double> lengths;
  for (const Words& way : ways) {
    lengths.push_back(length_of(way));
    for (const char* method : {"atherton-weiler", "warnock", "watkins"}) {
      Words arguments = way + Words{"--method", method};
      EXPECT_NEAR(length_of(arguments), lengths.back(), 0.002 * lengths.back()) << method << " " << way[0];
    }
  }
  EXPECT_NEAR(length_of("plain --hatch-spacing 3mm --view trimetric"), lengths[1] / 2, 0.1 * lengths[1]);
  EXPECT_GT(length_of("shade --hatch-levels 1 --view trimetric"), lengths[0]);
}

TEST_F(HatchTest, IsTheSameByEveryMethodBesideWallsSeenEdgeOn) {
  const std::string cells = LIGNE_SOURCE_DIR "/tests/cli/scenes/voronoi_cells.json";
  const double wanted = hatched_mm(cells, "shade --view top --hatch-angle face --method atherton-weiler");
  for (const char* spans : {"stack", "merge", "box", "point"}) {
    EXPECT_NEAR(hatched_mm(cells, {"shade", "--view", "top", "--hatch-angle", "face", "--method", "watkins", "--set",
                                   std::string("span-method=") + spans}),
                wanted, 0.1)
        << spans;
  }
}

/// Whether rows are spaced evenly depends on what is seen of a smooth surface, not on what the method knows of the rest.
TEST_F(HatchTest, ContinuousShadesAreTheSameByEveryMethod) {
  const std::string shell = LIGNE_SOURCE_DIR "/tests/cli/scenes/open_shell.json";
  for (const char* view : {"top", "front", "left", "iso"}) {
    const auto length_by = [&](const char* method) {
      return hatched_mm(shell, {"shade", "--view", view, "--hatch-levels", "continuous", "--method", method});
    };
    const double wanted = length_by("atherton-weiler");
    EXPECT_NEAR(length_by("warnock"), wanted, 0.1) << view;
    EXPECT_NEAR(length_by("watkins"), wanted, 0.1) << view;
  }
}

}  // namespace
}  // namespace ligne::test
