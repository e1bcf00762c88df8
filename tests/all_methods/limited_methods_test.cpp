// Methods that take a number of scan lines or of rows of pixels, on the corpus, with 512, 2048 and 8192 of them: what is
// larger than the lines can tell apart must be as the oracle says.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "main/tier.hpp"
#include "support/corpus_scene.hpp"
#include "support/judge.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

constexpr double kPageHeightMm = 210;
/// What a drawing by lines may be off, in distances of lines: what lies between two lines is seen by neither.
constexpr double kLines = 2;

constexpr std::uintmax_t kMostBytes = 20'000;

/// A method with no tolerance of its own: that of the lines alone counts.
class ByLines final : public Method {
 public:
  explicit ByLines(const Method& method) : method_(method), traits_(method.traits()) { traits_.tolerance_mm = 0; }
  const MethodTraits& traits() const override { return traits_; }
  VisibilityResult study(const ProjectedScene& scene, const StudyOptions& options) const override {
    return method_.study(scene, options);
  }

 private:
  const Method& method_;
  MethodTraits traits_;
};

bool shows_fine_pixels(const std::filesystem::path& file) {
  constexpr const char* kNames[] = {"crumpled_ball", "cyclic_3", "bricks", "two_prisms_penetrating"};
  return std::find(std::begin(kNames), std::end(kNames), file.stem().string()) != std::end(kNames);
}

class LimitedMethods : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LimitedMethods, AgreeWithTheOracleWithinTheirLines) {
  const Scene scene = scene_of_file(GetParam());
  const std::string scene_name = GetParam().stem().string();
  std::size_t turn = 0;
  for (const unsigned lines : {512u, 2048u, 8192u}) {
    for (const StandardView& view : standard_views(scene)) {
      const std::string name = view.name;
      if (name != "odd" && name != "iso" && name != "near") continue;
      // Nine pairs of a number of lines and a view, of which the first tier takes one for each scene.
      if (!is_chosen("limited, " + scene_name, turn++, 9)) continue;
      const JudgedView judged(scene, scene_name, view, kLines * kPageHeightMm / lines);
      for (const Method* method : all_methods()) {
        const auto own = method->traits().parameters;
        if (std::none_of(own.begin(), own.end(), [](const MethodParameter& p) { return p.name == "lines"; })) continue;
        // 8192 rows are 100 million pixels: enough for a few scenes.
        if (lines > 2048 && (method->traits().products & kPixels) && !shows_fine_pixels(GetParam())) continue;
        MethodSettings settings;
        settings.set("lines", lines);
        for (const char* edges : {"all", "feature"}) {
          const Verdict verdict = judged.judge(ByLines(*method), edges, settings);
          EXPECT_TRUE(verdict.passes()) << "--lines " << lines << '\n' << verdict.faults;
        }
        if (lines > 512) continue;
        for (const MethodParameter& p : own) {  // the other ways in which it can work
          for (unsigned word = 0; p.high == 0 && word < p.words.size(); ++word) {
            if (p.words[word] == p.standard) continue;
            MethodSettings other = settings;
            other.set(p.name, ParameterWord{word});
            const Verdict verdict = judged.judge(ByLines(*method), "all", other);
            EXPECT_TRUE(verdict.passes()) << "--lines " << lines << " --" << p.name << ' ' << p.words[word] << '\n'
                                          << verdict.faults;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, LimitedMethods, testing::ValuesIn(corpus_files(kMostBytes)),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
