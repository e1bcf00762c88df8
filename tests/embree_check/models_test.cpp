/// Drawings that the program itself makes of real models, checked by rays. By default a few views of each; all of them with
/// LIGNE_CHECK_ALL=1 in the environment.

#include "check.hpp"
#include "main/script.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"

namespace ligne::check {
namespace {

/// Largest part of the drawn length that may be wrong, and that may be not drawn.
constexpr double kLimit = 0.0005;
const bool kEverything = std::getenv("LIGNE_CHECK_ALL") != nullptr;

/// "EDGES MODEL OPTIONS"
void expect_right(const std::string& text) {
  std::string_view rest = text;
  const std::string edges = test::take_word(rest), name = test::take_word(rest), options_of_view(rest);
  const std::filesystem::path model = std::filesystem::path(LIGNE_MODELS_DIR) / name;
  const test::TemporaryFolder folder;
  const std::filesystem::path drawing = folder / "drawing.json";
  const std::string fov = rest.starts_with("--eye") ? " --fov 50" : "";
  const std::string command = std::string("\"") + LIGNE_PROGRAM + "\" draw -q \"" + model.string() + "\" " +
                              options_of_view + fov + " --quality exact --edges " + edges + " -o \"" + drawing.string() +
                              "\"";
  CheckOptions options;
  options.kinds = edges == "all" ? kAllKinds : kFeatureKinds;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  Warnings warnings;
  const Scene scene = read_scene(model, {}, warnings);
  const Report report = check_drawing(scene, parse_drawing(test::bytes_of_file(drawing)), options);
  const std::string found = command + "\n" + to_text(report, 10);
  EXPECT_GT(report.drawn, 500) << found;
  EXPECT_LE(report.share(report.drawn_wrong()), kLimit) << found;
  EXPECT_LE(report.share(report.not_drawn()), kLimit) << found;
  EXPECT_LE(report.share(report.drawn_undecided + report.missing_undecided), 10 * kLimit) << found;
  if (kEverything) std::fputs(found.c_str(), stdout);
}

/// Steps: "draw EDGES MODEL OPTIONS", and "more ...", which is done where all is asked for.
[[maybe_unused]] const bool models_are_added =
    test::add_scripts(LIGNE_SOURCE_DIR "/tests/embree_check/models", [](const test::Script& script) {
      if (!std::filesystem::exists(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
      for (const test::ScriptStep& step : script.steps)
        if (kEverything || step.line.starts_with("draw ")) expect_right(step.line.substr(5));
    });

}  // namespace
}  // namespace ligne::check
