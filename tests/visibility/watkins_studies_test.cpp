// How many lines a scan by lines studies: as many as there are changes that can be seen, however many lines there are. And
// who is in front where faces touch, which is what keeps it so.

#include <gtest/gtest.h>

#include "scene/clean/clean.hpp"
#include "support/line_scans.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

std::uint64_t studied(const PreparedScan& p, std::uint32_t lines) { return p.study(lines, kRecognising).scan.studied; }

/// Cost follows the changes in the scene, not its height. From some number of lines on no two changes share a line, and
/// twice the lines are as many studies; with fewer lines some changes share one, or come so close to an edge that they are
/// looked at.
TEST(WatkinsStudies, TwiceTheLinesAreNoMoreStudies) {
  for (const char* name : {"cube", "cyclic_3", "stair", "thesis_2_52d_n5", "plate_many_holes", "bricks"}) {
    const PreparedScan p(corpus_scene(name), kOdd);
    const std::uint64_t many = studied(p, 32768);
    EXPECT_EQ(studied(p, 16384), many) << name;
    for (const std::uint32_t lines : {2048u, 4096u, 8192u})
      EXPECT_NEAR(double(studied(p, lines)), double(many), 1 + 0.1 * double(many)) << name << ' ' << lines;
    EXPECT_LT(many, 200u) << name;
  }
}

/// On every scene without penetration, faces that touch, coincide, lie on each other or not. Changes at one height but for a
/// step of the lattice fall on one line or on two.
TEST(WatkinsStudies, TwiceTheLinesAreNoMoreStudiesOnAllScenes) {
  constexpr std::uintmax_t kMostBytes = 20'000;
  constexpr std::uint32_t kLines = 1u << 16;
  std::size_t scenes = 0;
  for (const std::filesystem::path& file : corpus_files(kMostBytes)) {
    const std::string name = file.stem().string();
    const PreparedScan p(corpus_scene(name), kOdd);
    if (p.lines.size() > p.projected.edges.size()) continue;
    const std::uint64_t once = studied(p, kLines), twice = studied(p, 2 * kLines);
    EXPECT_NEAR(double(once), double(twice), 2) << name;
    ++scenes;
  }
  EXPECT_GT(scenes, 80u);
}

/// The same city with its digits rounded: faces touch within the digits of the file, and their depths change places from
/// line to line.
TEST(WatkinsStudies, FacesThatTouchAreNoChanges) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / "CITY.ASC";
  if (!std::filesystem::exists(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  const PreparedScan p(scene_of_file(file), CameraRequest{});
  const std::uint64_t many = studied(p, 32000);
  EXPECT_LT(many, 600u);
  EXPECT_NEAR(double(studied(p, 16000)), double(many), 0.02 * double(many));
  EXPECT_NEAR(double(studied(p, 8000)), double(many), 0.05 * double(many));
}

/// Penetrations of which no edge of the scene tells: they are followed from study to study.
TEST(WatkinsStudies, PenetrationsWithoutAnEdgeAreCarriedOn) {
  for (const char* name : {"two_plates_penetrating", "cross_of_plates", "grazing_plates"}) {
    PreparedScan p(corpus_scene(name), kOdd);
    p.lines.resize(p.projected.edges.size());
    const LineStudyResult r = p.study(4096, kRecognising);
    EXPECT_LT(r.scan.studied, 60u) << name;
    EXPECT_EQ(p.study(8192, kRecognising).scan.studied, r.scan.studied) << name;
  }
}

/// Two plates over each other, seen from above; the second one `lift` higher at each of its corners.
struct TwoPlates {
  ProjectedScene projected;
  Facets facets;

  explicit TwoPlates(std::array<double, 4> lift) {
    Scene scene;
    add_face(scene, {{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}});
    add_face(scene, {{{2, 2, lift[0]}, {12, 2, lift[1]}, {12, 12, lift[2]}, {2, 12, lift[3]}}});
    Warnings warnings;
    finish_scene(scene, warnings);
    const View view =
        make_view(scene, make_camera(along({0.1, 0.2, -1}), scene), {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
    projected = project(scene, build_topology(scene), view, {classes("all"), 30});
    facets = make_facets(projected, coincidence_mm(projected) / projected.lattice.step_mm);
  }

  DepthOrder order(std::uint32_t a, std::uint32_t b) const {
    const FacetsOfFaces of_faces(facets.facets, 2);
    FaceOrders orders(projected.vertices, facets.facets, of_faces);
    const DepthOrder first = orders.of(a, b);
    EXPECT_EQ(orders.of(a, b), first) << "remembered";
    EXPECT_EQ(orders.pairs(), 1u);
    return first;
  }
};

TEST(WatkinsStudies, OrderOfAPairIsThatOfItsWholeOverlap) {
  const auto expect = [](const TwoPlates& plates, DepthOrder zero_one, DepthOrder one_zero) {
    EXPECT_EQ(plates.order(0, 1), zero_one);
    EXPECT_EQ(plates.order(1, 0), one_zero);
  };
  expect(TwoPlates({0, 0, 0, 0}), DepthOrder::first, DepthOrder::second);  // touch all over: the lower number
  expect(TwoPlates({1e-12, -1e-12, -1e-12, 1e-12}), DepthOrder::first, DepthOrder::second);  // but for roundings
  expect(TwoPlates({0, 1, 1, 0}), DepthOrder::second,
         DepthOrder::first);  // touch along a line: the second is higher elsewhere
  expect(TwoPlates({0, -1, -1, 0}), DepthOrder::first, DepthOrder::second);
  expect(TwoPlates({-1, 1, 1, -1}), DepthOrder::crossing, DepthOrder::crossing);  // pass through each other
}

}  // namespace
}  // namespace ligne::watkins
