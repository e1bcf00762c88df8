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

}  // namespace
}  // namespace ligne::test
