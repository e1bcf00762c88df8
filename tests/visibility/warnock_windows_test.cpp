// Windows with borders in any direction, of the method warnock.

#include "drawing/measures.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
#include "support/test.hpp"
#include "visibility/warnock_tools.hpp"

namespace ligne::test {
namespace {

using namespace warnock;

double area(const ConvexWindow& w) {
  double twice = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const FramePoint a = w.corner(i), b = w.corner((i + 1) % w.size());
    twice += a.u * b.v - a.v * b.u;
  }
  return twice / 2;
}

TEST(WarnockPolygon, DividedAlongTheSideThatStandsInTheWay) {
  Stage stage("face -900,-800,1 -100,-600,1 -500,-100,1; rectangle -600 -600 -200 -200 2");
  const FaceTable& table = stage.table();
  AnalysisCounts counts;
  const Analysis analysis(table, 1, true);
  const Window whole{-1000, 1000, -1000, 1000};
  const ConvexWindow window(whole);
  const auto border = [&](const ConvexWindow& w, const std::vector<Element>& elements, double limit) {
    Lists lists;
    lists.elements = elements;
    return dividing_border(table, lists, w, w.shrunk(1), 1, limit);
  };
  const std::vector<Element> elements = analysis.begin(whole, counts).elements;
  const std::optional<Border> side = border(window, elements, 0);
  ASSERT_TRUE(side);
  EXPECT_EQ(side->side({-900, -800}), 0) << "of the nearer face the side that passes nearest to the middle";
  EXPECT_EQ(side->side({-500, -100}), 0);
  // Inside that side the other two divide, then none of the face does.
  ConvexWindow rest = window;
  for (int i = 0; i < 3; ++i) {
    const std::optional<Border> next = border(rest, {elements.front()}, 0);
    ASSERT_TRUE(next);
    rest = rest.part(next->side({-500, -500}) > 0 ? *next : next->opposite());
  }
  EXPECT_NEAR(area(rest), 240000, 1e-6) << "the triangle itself";
  EXPECT_NEAR(border(rest, {elements.front()}, 0)->distance({-500, -450}), 0, 1) << "across the middle of its box";
  EXPECT_FALSE(border(window, elements, 2000)) << "at the limit of resolution";
}

/// Windows studied at a limit of resolution of 1024.
std::uint64_t windows_of(const ProjectedScene& projected, unsigned split) {
  VisibilityOptions options;
  options.wanted = kStrokes;
  options.settings.set("warnock-split", ParameterWord{split});
  options.settings.set("resolution", 1024u);
  return count_of(find_method("warnock")->compute_visibility(projected, options).statistics, "windows studied");
}

TEST(WarnockPolygon, DivisionAlongSidesSavesWindowsInEveryView) {
  constexpr unsigned kCentre = 0, kVertex = 1, kSide = 2;
  const Scene scene = corpus_scene("thesis_2_2");
  for (const StandardView& view : standard_views(scene)) {
    const ProjectedScene projected =
        project(scene, build_topology(scene), view_on_a4(scene, view.camera), {classes("feature"), 30});
    const std::uint64_t sides = windows_of(projected, kSide);
    EXPECT_LE(sides, windows_of(projected, kVertex)) << view.name;
    EXPECT_LE(2 * sides, windows_of(projected, kCentre)) << view.name;
    if (view.name != "iso") continue;
    EXPECT_EQ(sides, 35u);
    EXPECT_EQ(windows_of(projected, kVertex), 769u);
  }
}

// Areas of the method warnock. On the corpus: atherton_weiler/regions_test.cpp.

struct Areas {
  ProjectedScene projected;
  std::vector<Region> regions;
};

Areas areas_of(const Scene& scene, const CameraRequest& camera, const MethodSettings& settings = {}) {
  Areas result{project_on_a4(scene, camera), {}};
  VisibilityOptions options;
  options.settings = settings;
  result.regions = *find_method("warnock")->compute_visibility(result.projected, options).regions;
  return result;
}

/// A plate of 4 x 3 behind a cube: what is seen of both together is the plate, seen from above.
TEST(WarnockAreas, AddUpToThePlateBehind) {
  Scene scene;
  add_face(scene, {{{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}});
  add_box(scene, {0, 0, 2}, {2, 2, 1}, rotation(0.3, 0.2, 0.4));
  add_box(scene, {1, 0, 2}, {2, 1, 1}, rotation(0.1, -0.6, 0.2));  // penetrates the other
  for (const unsigned window : {0u, 1u, 2u}) {                     // screen, bounding, principal
    for (const unsigned split : {0u, 1u}) {
      MethodSettings settings;
      settings.set("warnock-window", ParameterWord{window});
      settings.set("warnock-split", ParameterWord{split});
      const Areas areas = areas_of(scene, along({0, 0, -1}), settings);
      double total = 0;
      for (const Region& r : areas.regions) total += area_of(r);
      const double scale = areas.projected.view.scale;
      // Every corner is rounded to the lattice: half a step along the rim.
      EXPECT_NEAR(total, 48 * scale * scale, 28 * scale * areas.projected.lattice.step_mm) << window << " " << split;
      const auto of_plate =
          std::count_if(areas.regions.begin(), areas.regions.end(), [](const Region& r) { return r.face == 0; });
      EXPECT_EQ(of_plate, 1);
      EXPECT_EQ(areas.regions[0].contours.size(), 2u) << "the plate has one hole, where the boxes are";
    }
  }
}

/// A bar before a plate cuts it in two; a plate with a hole shows what is behind.
TEST(WarnockAreas, OneRegionForEachPieceWithItsHoles) {
  const Scene scene =
      scene_of_faces({{{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}}, {{-1, -5, 1}, {1, -5, 1}, {1, 5, 1}, {-1, 5, 1}}});
  const Areas cut = areas_of(scene, along({0, 0, -1}));
  ASSERT_EQ(cut.regions.size(), 3u);
  EXPECT_EQ(cut.regions[0].face, 0u);
  EXPECT_EQ(cut.regions[1].face, 0u);
  EXPECT_EQ(cut.regions[2].face, 1u);
  for (const Region& r : cut.regions) {
    EXPECT_EQ(r.contours.size(), 1u);
    EXPECT_EQ(r.contours[0].size(), 4u) << "no corners but the four";
  }
}

}  // namespace
}  // namespace ligne::test
