/// Every point of a clear drawing lies within the sag of the mesh there and half a pen of a visible line of the exact one,
/// and what is left out is as short as cleanup promises.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>

#include "clear/clear_against_exact.hpp"
#include "clear/mesh_sags.hpp"
#include "clear/rounded_parts.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne::test {
namespace {

namespace fs = std::filesystem;

const std::string kViews[] = {"iso", "front", "right", "top"};

/// Cleanup closes gaps of up to twelve pens between lines that continue each other, and leads ends on by up to three
/// (docs/clear-lines.md, "Short bits").
constexpr double kLongestBridgeMm = 12 * kPenMm, kFarthestBridgeMm = 3 * kPenMm;
/// An outline of the mesh that its contour does not follow, as beyond a cusp, is as long as two edges or a spur.
constexpr int kLeftOutEdges = 2;
constexpr double kLongestSpurMm = 12 * kPenMm;
/// Before the sheet nothing is left out but bits.
constexpr double kLongestBitMm = 1.5 * kPenMm;

/// Scans have folds and grain that clear lines leave out whatever their length (docs/clear-lines.md, "Scans").
enum class Kind : std::uint8_t { exact_shape, scan };

void expect_close(const fs::path& file, const std::string& view, Kind kind) {
  SCOPED_TRACE("./ligne.sh draw " + file.string() + " --view " + view);
  const ClearDifferences found = compare_clear(file, view);
  if (found.exact_mm > kLongestSpurMm) {
    EXPECT_GT(found.clear_mm, 0);
  }
  EXPECT_TRUE(found.outside.empty()) << "ink outside the body:\n" << text_of(found.outside);
  for (const Run& run : found.added) {
    EXPECT_TRUE(run.length_mm <= kLongestBridgeMm && run.farthest_mm <= kFarthestBridgeMm) << "ink where no line is:\n"
                                                                                           << text_of({run});
  }
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
    for (const std::string& view : kViews) expect_close(entry.path(), view, Kind::exact_shape);
  }
}

class MadePart : public testing::TestWithParam<std::tuple<std::string_view, int>> {};

TEST_P(MadePart, IsClose) {
  const auto& [name, steps] = GetParam();
  const fs::path file =
      fs::temp_directory_path() / ("ligne-clear-" + std::string(name) + "-" + std::to_string(steps) + ".stl");
  write_stl(rounded_part(name, steps), file);
  for (const std::string& view : kViews) expect_close(file, view, Kind::exact_shape);
  fs::remove(file);
}

INSTANTIATE_TEST_SUITE_P(ClearAgainstExact, MadePart,
                         testing::Combine(testing::ValuesIn(kRoundedParts), testing::Values(3, 4, 6, 12)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + std::to_string(std::get<1>(info.param));
                         });

class SharedModel : public testing::TestWithParam<const char*> {};

TEST_P(SharedModel, IsClose) {
  const fs::path file = fs::path(LIGNE_MODELS_DIR) / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string name = GetParam();
  const Kind kind = name == "stanford-bunny.obj" || name == "rocker-arm.obj" ? Kind::scan : Kind::exact_shape;
  for (const std::string& view : kViews) expect_close(file, view, kind);
}

INSTANTIATE_TEST_SUITE_P(ClearAgainstExact, SharedModel,
                         testing::Values("1002_tray_bottom.stl", "2CylinderEngine.glb", "CITY.ASC", "beetle.obj",
                                         "chair_model.obj", "cornell_box.obj", "cycloidal.ply", "featuretype.stl",
                                         "no_indices_3storybuilding.glb", "octagonal_pocket.ply", "quadknot.obj",
                                         "rocker-arm.obj", "simple_pole.glb", "spider.obj", "stanford-bunny.obj",
                                         "teapot.obj"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

/// A prism of n sides stands for a cylinder, from which the middles of its sides lie r (1 - cos(pi / n)) away.
TEST(MeshSags, OfAPrismIsThatOfItsCylinder) {
  constexpr int kSides = 16;
  constexpr double kRadius = 10, kTurn = 2 * 3.14159265358979323846 / kSides;
  Scene scene;
  for (int i = 0; i < 2 * kSides; ++i) {
    scene.vertices.push_back({kRadius * std::cos(kTurn * (i / 2)), kRadius * std::sin(kTurn * (i / 2)), i % 2 ? 30.0 : 0.0});
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
    scene.faces.add_face(std::array{a, b, b + 1, a + 1});
  }
  scene.objects.push_back({});
  scene.objects.back().vertex_end = 2 * kSides;
  scene.objects.back().face_end = kSides;
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

}  // namespace
}  // namespace ligne::test
