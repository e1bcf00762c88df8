// Methods that take a number of scan lines, on the corpus, with 512, 2048 and 8192 of them: what is larger than the lines
// can tell apart must be as the oracle says.

#include <gtest/gtest.h>

#include <filesystem>

#include "scene/readers/reader.hpp"
#include "support/judge.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

constexpr double kPageHeightMm = 210;
/// What a drawing by lines may be off, in distances of lines: what lies between two lines is seen by neither.
constexpr double kLines = 2;

std::vector<std::filesystem::path> small_scenes() {
  constexpr std::uintmax_t kLargeBytes = 20'000;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus")) {
    if (entry.path().extension() == ".json" && entry.file_size() < kLargeBytes) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class LimitedMethods : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LimitedMethods, AgreeWithTheOracleWithinTheirLines) {
  Warnings warnings;
  const Scene scene = read_scene(GetParam(), {}, warnings);
  for (const unsigned lines : {512u, 2048u, 8192u}) {
    for (const StandardView& view : standard_views(scene)) {
      const std::string name = view.name;
      if (name != "odd" && name != "iso" && name != "near") continue;
      const JudgedView judged(scene, GetParam().stem().string(), view, kLines * kPageHeightMm / lines);
      for (const Method* method : all_methods()) {
        for (const MethodParameter& p : method->traits().parameters) {
          if (p.name != "lines") continue;
          MethodSettings settings;
          settings.set(p.name, lines);
          for (const char* edges : {"all", "feature"}) {
            const Verdict verdict = judged.judge(*method, edges, settings);
            EXPECT_TRUE(verdict.passes()) << "--lines " << lines << '\n' << verdict.faults;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, LimitedMethods, testing::ValuesIn(small_scenes()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
