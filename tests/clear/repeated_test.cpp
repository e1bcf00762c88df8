/// Clear drawings that are cleaned again, and pictures that are refined.

#include "base/no_index.hpp"
#include "clear/true_parts.hpp"
#include "picture/clear/tidy_strokes.hpp"
#include "picture/draw_scene.hpp"
#include "picture/models/models.hpp"
#include "picture/scene_visibility.hpp"
#include "support/corpus_scene.hpp"
#include "support/page_lines.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

// Cleaning is idempotent on real drawings too: scenes of the corpus, and models where they are at hand.

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

// Drawings of refined parts name the faces and edges of the given scene.

TEST(RefinedPicture, NamesGivenFacesAndEdges) {
  for (const TruePart& part : true_parts()) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / (part.name + ".stl");
    write_mesh(part, 12, file);
    const Scene scene = load_models({.files = {file.string()}}).scene;
    const Topology topology = build_topology(scene);
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, {}, run, std::nullopt, {}, true);
    const SceneVisibility& found = drawn.visibility();
    const StrokeModel& model = *found.result.strokes;
    EXPECT_EQ(&drawn.prepared().scene, &scene) << part.name;
    ASSERT_EQ(found.edges.size(), topology.edges.size()) << part.name;
    const FoundSurfaces surfaces = drawn.surfaces();
    if (!surfaces.list.empty()) {
      EXPECT_EQ(surfaces.of_face.size(), scene.faces.size()) << part.name;
    }
    for (const Stroke& s : model.strokes) {
      const SourceEdge source = found.source(scene, s.source);
      for (const std::uint32_t face : source.faces) EXPECT_TRUE(face == kNone || face < scene.faces.size()) << part.name;
      if (s.source >= found.edges.size()) continue;
      const Point2 from = page_point(drawn.prepared().view(), source.ends[0]),
                   to = page_point(drawn.prepared().view(), source.ends[1]);
      EXPECT_LT(distance_to_segment(model.lattice.to_mm(s.from), from, to), 2.0) << part.name;
    }
  }
}

}  // namespace
}  // namespace ligne::test
