// The order of painting of every method that gives one, on every scene of the corpus in every standard view, against the
// oracle.

#include "main/tier.hpp"
#include "order_check.hpp"
#include "support/corpus_scene.hpp"
#include "support/test.hpp"
#include "support/variants.hpp"

namespace ligne::test {
namespace {

constexpr int kPoints = 60;

/// A variant is asked about every third scene of a family; it meets each family.
bool is_asked(const Variant& variant, const std::filesystem::path& file) {
  return is_chosen("orders, " + family_of(file) + variant.name, place_in_family(file), 3);
}

class Orders : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Orders, PaintNothingOverWhatIsNearer) {
  const Scene scene = scene_of_file(GetParam());
  const std::string name = GetParam().stem().string();
  const Topology topology = build_topology(scene);
  int covered = 0;
  for (const StandardView& standard : rotated_views(scene, "orders, " + name, 1)) {
    const JudgedView judged(scene, name, standard);
    EdgeSelection all;
    all.classes.bits = 0xff;
    const ProjectedScene projected = project(scene, topology, judged.view(), all);
    for (const Variant& variant : variants()) {
      if (!(variant.method->traits().products & kOrder) || (variant.is_show && !runs_all())) continue;
      if (!is_asked(variant, GetParam())) continue;
      SCOPED_TRACE(standard.name + ", " + variant.name);
      VisibilityOptions options;
      options.settings = variant.settings;
      const VisibilityResult result = variant.method->compute_visibility(projected, options);
      ASSERT_TRUE(result.order.has_value());
      if (!result.unsupported_reason.empty()) continue;  // the method says that its order may be wrong
      const OrderVerdict verdict = check_order(*result.order, judged.oracle(), 1, kPoints);
      EXPECT_EQ(verdict.faults, "");
      covered += verdict.covered;
    }
  }
  RecordProperty("points_with_an_order", covered);
}

INSTANTIATE_TEST_SUITE_P(Corpus, Orders, testing::ValuesIn(corpus_files(kLargeSceneBytes)),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
