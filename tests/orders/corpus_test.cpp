// The order of painting of every method that gives one, on every scene of the corpus in every standard view, against the
// oracle.

#include <gtest/gtest.h>

#include <filesystem>

#include "order_check.hpp"
#include "scene/readers/reader.hpp"
#include "support/variants.hpp"

namespace ligne::test {
namespace {

constexpr int kPoints = 60;

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus")) {
    constexpr std::uintmax_t kLargeBytes = 100'000;
    if (entry.path().extension() == ".json" && entry.file_size() <= kLargeBytes) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Orders : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Orders, PaintNothingOverWhatIsNearer) {
  Warnings warnings;
  const Scene scene = read_scene(GetParam(), {}, warnings);
  const Topology topology = build_topology(scene);
  int covered = 0;
  for (const StandardView& standard : standard_views(scene)) {
    const JudgedView judged(scene, GetParam().stem().string(), standard);
    EdgeSelection all;
    all.classes.bits = 0xff;
    const ProjectedScene projected = project(scene, topology, judged.view(), all);
    for (const Variant& variant : variants()) {
      if (!(variant.method->traits().products & kOrder)) continue;
      SCOPED_TRACE(standard.name + ", " + variant.name);
      StudyOptions options;
      options.settings = variant.settings;
      const VisibilityResult result = variant.method->study(projected, options);
      ASSERT_TRUE(result.order.has_value());
      if (!result.beyond.empty()) continue;  // the method says that its order may be wrong
      const OrderVerdict verdict = check_order(*result.order, judged.oracle(), 1, kPoints);
      EXPECT_EQ(verdict.faults, "");
      covered += verdict.covered;
    }
  }
  RecordProperty("points_with_an_order", covered);
}

INSTANTIATE_TEST_SUITE_P(Corpus, Orders, testing::ValuesIn(corpus()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
