/// Cleaning is idempotent on real drawings too: scenes of the corpus, and models where they are at hand.

#include "picture/clear/tidy_strokes.hpp"
#include "picture/models/models.hpp"
#include "picture/scene_visibility.hpp"
#include "support/corpus_scene.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

/// Finds the lines of the scene and cleans them once more, while the projected scene, which cleaning reads, is still there.
/// Returns the number of strokes.
std::size_t expect_clean(const Scene& scene, const std::string& view, const std::string& name) {
  PictureRequest request;
  request.view.named_view = view;
  RunReport run;
  PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  SceneVisibility found = compute_visibility(prepared, std::nullopt, false, run);
  finish_lines(found, prepared, run);
  StrokeModel& strokes = *found.result.strokes;
  const std::size_t before = strokes.strokes.size();
  for (const RuleReport& report : clean_scene_lines(strokes, prepared, least_bit_mm(prepared)).rules)
    EXPECT_EQ(report.count, 0u) << name << ", " << view << ": " << report.changes;
  EXPECT_EQ(strokes.strokes.size(), before);
  return before;
}

TEST(CleanAgain, ChangesNoSceneOfTheCorpus) {
  std::size_t strokes = 0;
  for (const std::filesystem::path& file : test::corpus_files(test::kLargeSceneBytes))
    strokes += expect_clean(test::scene_of_file(file), "iso", file.filename().string());
  EXPECT_GT(strokes, 1000u);
}

/// Parts, a scan, a car of sheets, penetrating bodies.
class CleanAgainModels : public testing::TestWithParam<const char*> {};
TEST_P(CleanAgainModels, ChangesNothing) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "shared models are absent";
  const Scene scene = load_models({.files = {file.string()}}).scene;
  for (const char* view : {"iso", "front"}) EXPECT_GT(expect_clean(scene, view, GetParam()), 100u);
}
INSTANTIATE_TEST_SUITE_P(Models, CleanAgainModels,
                         testing::Values("2CylinderEngine.glb", "beetle.obj", "chair_model.obj", "cycloidal.ply",
                                         "rocker-arm.obj", "spider.obj", "stanford-bunny.obj", "teapot.obj"));

}  // namespace
}  // namespace ligne
