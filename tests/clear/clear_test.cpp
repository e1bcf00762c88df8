/// Every point of a clear drawing lies within the sag of the mesh there and half a pen of a visible line of the exact one,
/// and what is left out is as short as cleanup promises.

#include "base/no_index.hpp"
#include "clear/clear_against_exact.hpp"
#include "clear/true_parts.hpp"
#include "main/script.hpp"
#include "main/tier.hpp"
#include "picture/clear/tidy_strokes.hpp"
#include "picture/draw_scene.hpp"
#include "picture/models/models.hpp"
#include "picture/scene_visibility.hpp"
#include "support/corpus_scene.hpp"
#include "support/mesh_text.hpp"
#include "support/page_lines.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

namespace fs = std::filesystem;

const std::string kViews[] = {"iso", "front", "right", "top"};

/// The views in which a model is drawn: in the first tier one of them, which the seed chooses.
std::vector<std::string> views_of(const std::string& model) { return chosen("clear, " + model, std::size(kViews), kViews); }

/// Cleanup closes gaps of up to twelve pens between lines that continue each other, and leads ends on by up to six, whose
/// ink lies within three of a line (docs/clear-lines.md, "Short bits").
constexpr double kLongestBridgeMm = 12 * kPenMm, kFarthestBridgeMm = 3 * kPenMm;
/// An outline of the mesh that its contour does not follow, as beyond a cusp, is as long as two edges or a spur.
constexpr int kLeftOutEdges = 2;
constexpr double kLongestSpurMm = 12 * kPenMm;
/// Before the sheet nothing is left out but bits.
constexpr double kLongestBitMm = 1.5 * kPenMm;

/// Scans have folds and grain that clear lines leave out whatever their length (docs/clear-lines.md, "Scans").
enum class Kind : std::uint8_t { exact_shape, scan };

void expect_close(const fs::path& file, const std::string& view, Kind kind,
                  const std::optional<Point3>& axis = std::nullopt) {
  SCOPED_TRACE("./ligne.sh draw " + file.string() + " --view " + view);
  const ClearDifferences found = compare_clear(file, view, axis);
  if (found.exact_mm > kLongestSpurMm) {
    EXPECT_GT(found.clear_mm, 0);
  }
  EXPECT_TRUE(found.outside.empty()) << "ink outside the body:\n" << text_of(found.outside);
  for (const Run& run : found.added)
    EXPECT_TRUE(run.length_mm <= kLongestBridgeMm && run.farthest_mm <= kFarthestBridgeMm) << "ink where no line is:\n"
                                                                                           << text_of({run});
  for (const Run& run : found.left_out) {
    if (run.layer != "outline") continue;
    const bool is_bit = run.length_mm <= (kind == Kind::scan ? kLongestSpurMm : kLongestBitMm);
    const bool is_fold = kind == Kind::scan || run.segments <= kLeftOutEdges || run.length_mm <= kLongestSpurMm;
    EXPECT_TRUE(is_bit || (is_fold && !run.before_the_sheet)) << "an outline left out:\n" << text_of({run});
  }
}

TEST(ClearAgainstExact, Corpus) {
  for (const fs::directory_entry& entry : fs::directory_iterator(LIGNE_SOURCE_DIR "/tests/corpus")) {
    if (entry.path().extension() != ".json") continue;
    for (const std::string& view : views_of(entry.path().stem())) expect_close(entry.path(), view, Kind::exact_shape);
  }
}

/// Parts with roundings, tessellated at any accuracy: "part NAME [AXIS] <<" and its mesh. Its lines may lie on circles about
/// the axis.
[[maybe_unused]] const bool parts_are_added = add_scripts(LIGNE_SOURCE_DIR "/tests/clear/scripts", [](const Script& script) {
  for (const ScriptStep& step : script.steps) {
    const std::vector<std::string> words = words_of(step.line);
    const TemporaryFolder folder;
    const fs::path file = folder / (words.at(1) + ".obj");
    folder.write(words[1] + ".obj", obj_of_mesh(step.text));
    std::optional<Point3> axis;
    if (words.size() > 3) axis = point_of(words[2]);
    for (const std::string& view : views_of(words[1])) expect_close(file, view, Kind::exact_shape, axis);
  }
});

class SharedModel : public testing::TestWithParam<const char*> {};

TEST_P(SharedModel, IsClose) {
  const fs::path file = fs::path(LIGNE_MODELS_DIR) / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string name = GetParam();
  const Kind kind = name == "stanford-bunny.obj" || name == "rocker-arm.obj" ? Kind::scan : Kind::exact_shape;
  for (const std::string& view : views_of(name)) expect_close(file, view, kind);
}

INSTANTIATE_TEST_SUITE_P(ClearAgainstExact, SharedModel,
                         testing::Values("1002_tray_bottom.stl", "2CylinderEngine.glb", "CITY.ASC", "beetle.obj",
                                         "chair_model.obj", "cornell_box.obj", "cycloidal.ply", "featuretype.stl",
                                         "no_indices_3storybuilding.glb", "octagonal_pocket.ply", "quadknot.obj",
                                         "rocker-arm.obj", "simple_pole.glb", "spider.obj", "stanford-bunny.obj",
                                         "teapot.obj"),
                         kNameOfFile);

/// A prism of n sides stands for a cylinder, from which the middles of its sides lie r (1 - cos(pi / n)) away.
TEST(MeshSags, OfAPrismIsThatOfItsCylinder) {
  constexpr int kSides = 16;
  constexpr double kRadius = 10, kTurn = 2 * 3.14159265358979323846 / kSides;
  const Scene scene = mesh_of("grid 16 x 1 round: 10*cos(pi*u/8); 10*sin(pi*u/8); 30*v\nexact").scene();
  CameraRequest camera;
  camera.named_view = "front";
  const View view = make_view(scene, make_camera(camera, scene), {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
  const MeshSags sags(scene, build_topology(scene), view, 60);
  // Each side has two edges at which it bends; the sum of two is a surface that bends both ways.
  const double rise = kRadius * (1 - std::cos(kTurn / 2)) * view.scale;
  const Point2 middle = page_point(view, {0, 0, 15});
  ASSERT_TRUE(sags.at(middle, 0));
  EXPECT_NEAR(*sags.at(middle, 0), 2 * rise, 1e-9);
  const Point2 side = page_point(view, {kRadius, 0, 15});
  EXPECT_TRUE(sags.at(side + Point2(1.9 * rise, 0), 0));
  EXPECT_FALSE(sags.at(side + Point2(2.1 * rise, 0), 0)) << "outside";
}

// Clear drawings that are cleaned again, and pictures that are refined.

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
  for (const RuleReport& report : clean_scene_lines(strokes, prepared, {}, least_bit_mm(prepared)).rules)
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
