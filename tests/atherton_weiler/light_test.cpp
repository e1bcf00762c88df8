// Shadows, transparency and details on scenes whose areas are known. All are drawn from above or from the front, so
// that a region's area is that of the part of the face, at one page millimetre to a model unit.

#include "drawing/measures.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "picture/draw_scene.hpp"
#include "picture/light/detail_lines.hpp"
#include "picture/light/details.hpp"
#include "picture/light/seen_through.hpp"
#include "picture/light/shadows.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/atherton_weiler.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

using test::area_of;

using FaceAndLevel = std::pair<std::uint32_t, std::uint32_t>;

struct Seen {
  Scene scene;
  Topology topology;
  View view;
  std::vector<Region> regions;
  StrokeModel strokes;

  Seen(const char* name, const char* from, const Rect& window = {{0, 0}, {200, 200}}) {
    Warnings warnings;
    scene = read_scene(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/atherton_weiler/scenes" / name, {}, warnings);
    topology = build_topology(scene);
    CameraRequest request;
    request.named_view = from;
    view = make_view(scene, make_camera(request, scene), {{{0, 0}, {200, 200}}}, window, 1);
    EdgeSelection selection;
    for (std::size_t c = 0; c < kEdgeClassCount; ++c) selection.classes.add(static_cast<LineClass>(c));
    const ProjectedScene projected = project(scene, topology, view, selection);
    VisibilityResult result = AthertonWeilerMethod().compute_visibility(projected, {});
    regions = std::move(*result.regions);
    strokes = std::move(*result.strokes);
    remove_coincident_strokes(strokes, coincidence_mm(projected));
  }

  /// Areas of a face's regions by the lights that reach them.
  std::map<std::uint32_t, double> lit(std::uint32_t face, const std::vector<Light>& lights) const {
    std::map<std::uint32_t, double> areas;
    for (const Region& r : cast_shadows(scene, topology, view, lights, regions).regions)
      if (r.face == face) areas[r.lights] += area_of(r);
    return areas;
  }

  std::map<FaceAndLevel, double> areas() const {
    std::map<FaceAndLevel, double> sums;
    for (const Region& r : regions) sums[{r.face, r.level}] += area_of(r);
    return sums;
  }

  /// Areas of the first face's regions with details on them: in the details' material, and in all.
  std::array<double, 2> detail_areas() const {
    std::array<double, 2> sums{0, 0};
    for (const Region& r : cut_details(scene, view, regions)) {
      if (r.face != 0) continue;
      sums[1] += area_of(r);
      if (r.material == 1) sums[0] += area_of(r);
    }
    return sums;
  }

  /// Lengths of the borders of shadows that are drawn, by level.
  std::map<unsigned, double> shadow_lines(const std::vector<Light>& lights) const {
    StrokeModel model = strokes;
    add_shadow_strokes(scene, view, cast_shadows(scene, topology, view, lights, regions).borders, model);
    remove_coincident_strokes(model, 0.001);
    return lengths(model, [](const Stroke& s) { return s.line_class == LineClass::shadow; });
  }

  template <class Wanted>
  static std::map<unsigned, double> lengths(const StrokeModel& model, Wanted wanted) {
    std::map<unsigned, double> sums;
    for (const Stroke& s : model.strokes)
      if (wanted(s)) sums[s.level] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
    return sums;
  }
};

/// Contours go from page to page through the lattice: a step of 10 nm along some hundred millimetres.
constexpr double kArea = 1e-4;
/// A drawing owes its coordinates to a micrometre; a dozen ends.
constexpr double kLength = 0.01;

TEST(Shadows, ASquareOverAFloor) {
  // The shadow is the square, moved by 3: (5, 5) to (8, 8). The square hides (2, 2) to (5, 5) from above.
  const Seen seen("shadow_square.json", "top");
  const auto floor = seen.lit(0, seen.scene.lights), plate = seen.lit(1, seen.scene.lights);
  EXPECT_NEAR(floor.at(0), 9, kArea);
  EXPECT_NEAR(floor.at(1), 100 - 9 - 9, kArea);
  EXPECT_NEAR(plate.at(1), 9, kArea);
  EXPECT_EQ(plate.size(), 1u);
  const auto lines = seen.shadow_lines(seen.scene.lights);
  EXPECT_NEAR(lines.at(0), 4 * 3, kLength);
  EXPECT_EQ(lines.size(), 1u);
}

TEST(Shadows, AFrameOverAFloorInTwoLights) {
  // Parallel: the frame moved by (8, 8): (10, 10) to (14, 14), its hole (11, 11) to (13, 13). The point at (4, 4, 8)
  // doubles about (4, 4): (0, 0) to (8, 8), hole (2, 2) to (6, 6); of that the frame hides all but ... from above it
  // covers (2, 2) to (6, 6) less (3, 3) to (5, 5).
  const Seen seen("shadow_frame.json", "top");
  const auto floor = seen.lit(0, seen.scene.lights);
  EXPECT_NEAR(floor.at(2), 16 - 4, kArea);  // reached by the point only
  EXPECT_NEAR(floor.at(1), 64 - 16,
              kArea);  // reached by the parallel light only: the ring (0, 0) to (8, 8) round (2, 2) to (6, 6)
  EXPECT_NEAR(floor.at(3), 400 - 12 - 48 - 12, kArea);
  EXPECT_EQ(floor.count(0), 0u);
  // Half of the point's outer border lies on that of the floor; its inner border lies behind the frame's.
  EXPECT_NEAR(seen.shadow_lines(seen.scene.lights).at(0), (16 + 8) + 16, kLength);
}

TEST(Shadows, NoLinesWhereOneFaceIsCutIntoSeveral) {
  // The floor is two triangles; the shadow, (5, 6) to (8, 9), lies on both, and their common side is no border of it.
  const Seen seen("shadow_triangles.json", "top");
  EXPECT_NEAR(seen.lit(0, seen.scene.lights).at(0) + seen.lit(1, seen.scene.lights).at(0), 9, kArea);
  EXPECT_NEAR(seen.shadow_lines(seen.scene.lights).at(0), 4 * 3, kLength);
}

double perimeter(const Region& region) {
  double sum = 0;
  for (const auto& contour : region.contours)
    for (std::size_t i = 0; i < contour.size(); ++i) sum += glm::distance(contour[i], contour[(i + 1) % contour.size()]);
  return sum;
}

TEST(Shadows, NoSliversAlongTheBordersOfFaces) {
  // The lit part of a triangle ends at its border, on the light's page as on the viewer's, but rounded otherwise. The
  // two dark parts have the square's sides and, twice, the piece in it of the line from (0, 0) to (9.3, 10.7): nothing
  // that runs on along the line.
  const Seen seen("shadow_triangles_askew.json", "top");
  constexpr double kSlope = 10.7 / 9.3;
  for (const double x : {1.0, 1.01, 1.07, 1.13, 1.21}) {
    const std::vector<Light> lights{{Light::Kind::parallel, {x, 1.02, -1.1}}};
    const double dx = 3 * x / 1.1, dy = 3 * 1.02 / 1.1;  // the shadow is (2, 3) to (5, 6), moved by this
    const double from = std::max(2 + dx, (3 + dy) / kSlope), to = std::min(5 + dx, (6 + dy) / kSlope);
    double sum = 0;
    for (const Region& r : cast_shadows(seen.scene, seen.topology, seen.view, lights, seen.regions).regions)
      if (r.lights == 0 && r.face < 2) sum += perimeter(r);
    EXPECT_NEAR(sum, 4 * 3 + 2 * std::hypot(1, kSlope) * (to - from), kLength) << x;
  }
}

TEST(Shadows, TransparentFacesWeakenTheLight) {
  // Light falls by 1 where it goes 1 to the right. On the floor: red (6, 2) to (10, 6), blue (6, 4) to (10, 8), the
  // opaque square (18, 12) to (20, 16).
  const Seen seen("shadow_glass.json", "top");
  std::map<std::pair<std::uint32_t, double>, double> areas;  // by face and share
  for (const Region& r : cast_shadows(seen.scene, seen.topology, seen.view, seen.scene.lights, seen.regions).regions) {
    const double share = r.lights == 0 ? 0 : r.light_shares.empty() ? 1 : r.light_shares[0];
    areas[{r.face, std::round(share * 1000) / 1000}] += area_of(r);
  }
  EXPECT_NEAR((areas[{0, 0.0}]), 8, kArea);
  EXPECT_NEAR((areas[{0, 0.3}]), 8, kArea);
  EXPECT_NEAR((areas[{0, 0.5}]), 8, kArea);
  EXPECT_NEAR((areas[{0, 0.6}]), 8, kArea);
  EXPECT_NEAR((areas[{0, 1.0}]), 400 - 16 - 8 - 24, kArea);
  // Red onto blue, which is 2 lower: (4, 2) to (8, 6).
  EXPECT_NEAR((areas[{2, 0.6}]), 8, kArea);
  EXPECT_NEAR((areas[{2, 1.0}]), 8, kArea);
  EXPECT_NEAR((areas[{1, 1.0}]), 16, kArea);
  EXPECT_NEAR((areas[{3, 1.0}]), 16, kArea);
  EXPECT_EQ(areas.size(), 9u);
  // The opaque square: three sides, 8. Red and blue on the floor: x = 10 from 2 to 8; y = 2 from 6 to 10; y = 4, 6 and
  // 8 from 8 to 10, before that under blue's border or, y = 6, under the line that red casts on blue; x = 6 up to 6
  // under red's border, then to 8 behind blue. On blue: y = 6, up to x = 6 under red's border.
  const auto lines = seen.shadow_lines(seen.scene.lights);
  EXPECT_NEAR(lines.at(0), 8 + 6 + 4 + 2 + 2 + 2 + 2, kLength);
  EXPECT_NEAR(lines.at(1), 2, kLength);
}

TEST(Shadows, ALightBehindReachesNothing) {
  const Seen seen("shadow_square.json", "top");
  const auto floor = seen.lit(0, {{Light::Kind::parallel, {0, 0, 1}}}),
             point = seen.lit(0, {{Light::Kind::point, {5, 5, -4}}});
  EXPECT_NEAR(floor.at(0), 91, kArea);
  EXPECT_EQ(floor.size(), 1u);
  EXPECT_NEAR(point.at(0), 91, kArea);
}

TEST(Shadows, ALightBetweenFacesIsLookedAtAllRound) {
  const Seen seen("shadow_square.json", "top");
  // From (1, 1, 1) the plate, which is above, shades nothing of the floor.
  const auto floor = seen.lit(0, {{Light::Kind::point, {1, 1, 1}}});
  EXPECT_NEAR(floor.at(1), 91, kArea);
}

TEST(Transparency, LevelsAreListedToAnyDepth) {
  // Blue (7 x 7) before red (7 x 7) before the wall; they overlap in 4 x 4.
  const Seen seen("transparent_layers.json", "front");
  std::map<FaceAndLevel, double> areas = seen.areas();
  const auto at = [&](std::uint32_t face, std::uint32_t level) { return areas[{face, level}]; };
  EXPECT_NEAR(at(2, 0), 49, 1e-6);
  EXPECT_NEAR(at(1, 0), 49 - 16, 1e-6);
  EXPECT_NEAR(at(1, 1), 16, 1e-6);
  EXPECT_NEAR(at(0, 0), 144 - 49 - 49 + 16, 1e-6);
  EXPECT_NEAR(at(0, 1), 49 + 49 - 2 * 16, 1e-6);
  EXPECT_NEAR(at(0, 2), 16, 1e-6);
  EXPECT_EQ(areas.size(), 6u);
}

TEST(Transparency, OneTriangleOfGlassHidesNothing) {
  // The transparent faces has legs of 24. It covers the wall, 8 x 8, of which sixteen triangles with legs of 1 hide
  // half a unit each.
  const Seen seen("glass_triangle.json", "front");
  std::map<FaceAndLevel, double> areas = seen.areas();
  const auto at = [&](std::uint32_t face, std::uint32_t level) { return areas[{face, level}]; };
  EXPECT_NEAR(at(17, 0), 288, kArea);
  EXPECT_NEAR(at(0, 1), 64 - 16 * 0.5, kArea);
  for (std::uint32_t face = 1; face <= 16; ++face) EXPECT_NEAR(at(face, 1), 0.5, kArea) << face;
  EXPECT_EQ(areas.size(), 18u);
}

TEST(Transparency, LinesAreSeenThroughToAnyDepth) {
  // Green (3, 3) to (9, 9) before blue (4, 4) to (11, 11) before red (1, 1) to (8, 8), 28 round each of the latter.
  // Through green: of blue two sides of 5; of red two sides from 3 to 8, of which 4 to 8 lies behind blue too. The
  // window (5, 5) to (7, 7) is behind all. The plate that is seen edge on, x = 10 from 0.5 to 11.5, lies behind blue
  // from 4 on, to 11.
  const Seen seen("transparent_three.json", "front");
  const auto lines = Seen::lengths(seen.strokes, [](const Stroke& s) { return s.visible; });
  EXPECT_NEAR(lines.at(0), 24 + (28 - 10) + (28 - 10) + 48 + (11 - 7), kLength);
  EXPECT_NEAR(lines.at(1), 10 + 2 + 7, kLength);
  EXPECT_NEAR(lines.at(2), 8, kLength);
  EXPECT_NEAR(lines.at(3), 8, kLength);
  EXPECT_EQ(lines.size(), 4u);
  const Drawing drawing = make_drawing(seen.strokes);
  ASSERT_EQ(drawing.layers.size(), 2u);
  EXPECT_EQ(drawing.layers[0].name, "behind-glass");
  EXPECT_EQ(drawing.layers[1].name, "border");
}

TEST(Shadows, OfWhatGoesOnBeyondTheSheet) {
  // A floor that is a square on its tip, ten from the centre to each corner, all in the light; the sheet is the 3 x 3
  // in its middle.
  const Seen seen("lit_floor.json", "top", {{98.5, 98.5}, {101.5, 101.5}});
  const auto floor = seen.lit(0, seen.scene.lights);
  EXPECT_NEAR(floor.at(1), 9, kArea);
  EXPECT_EQ(floor.size(), 1u);
}

TEST(Details, AreCutAtTheSheet) {
  // Above z = 7: of the first detail the two horns beside the notch, 2.25 x 3 / 2 each; of the second 3.5 up to z = 8
  // and 4 above it.
  const Seen seen("details.json", "front", {{0, 0}, {200, 99}});
  const auto [painted, all] = seen.detail_areas();
  // Faces go on a little beyond the sheet (kWindowMarginSteps), along 16 mm.
  const double beyond = 16 * kWindowMarginSteps * page_lattice(seen.view).step_mm;
  EXPECT_NEAR(painted, 2 * 2.25 * 3 / 2 + 3.5 + 4, kArea + beyond);
  EXPECT_NEAR(all, 16 * 5, kArea + beyond);
}

TEST(Details, AreCutAtASmallSheet) {
  // The sheet is x = 9 to 10, z = 7 to 8: of the first detail what is to the left of the notch, which is at x = 10.25
  // at z = 7 and at x = 9.5 at z = 8. Its corners lie far outside.
  const Seen seen("details.json", "front", {{101, 98}, {102, 99}});
  const double painted = seen.detail_areas()[0];
  EXPECT_NEAR(painted, 1 - 0.5 * (2.0 / 3) / 2, kArea);
}

TEST(Details, AreClippedWithTheirFace) {
  // The first detail is 6 x 8 less a notch of 6 x 4 / 2 = 36; the bar takes one row of 6 from it. The second is a
  // triangle of base 6 and height 4, 12: the hole takes (4, 4) (6, 6) (4, 6) from it, 2; the bar z = 5 to 6 lies before
  // the hole and from x = 5..6 beside it nothing.
  const Seen seen("details.json", "front");
  const auto [painted, all] = seen.detail_areas();
  EXPECT_NEAR(painted, (36 - 6) + (12 - 2), kArea);
  EXPECT_NEAR(all, 192 - 16 - (16 - 4), kArea);
}

/// Lengths drawn of the details, in the view from the front, by every method that draws their face.
TEST(Details, AreLinesOfTheirOwnClass) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/atherton_weiler/scenes/details.json";
  Warnings warnings;
  const Scene scene = read_scene(file, {}, warnings);
  // The bar hides z = 5 to 6: the sides of the first detail at x = 8 and x = 14 lose 1 each. Its bottom has length 6,
  // the notch 5 twice. The hole removes the part of the second detail between (2, 2) and (6, 6).
  const double first = 7 + 6 + 7 + 5 + 5, second = std::sqrt(8) + std::sqrt(20) + 4;
  double on_face = 0;
  for (const DetailLine& line : detail_lines(scene)) {
    EXPECT_EQ(line.face, 0u);
    on_face += glm::distance(line.ends[0], line.ends[1]);
  }
  EXPECT_NEAR(on_face, first + 2 + second, kLength);
  for (const Method* method : all_methods()) {
    if (!method->traits().exact || !method->traits().only_for.empty()) continue;
    PictureRequest request;
    request.view.named_view = "front";
    request.page.margin_mm = 0;
    request.page.scale = 1;
    request.lines.method = method;
    request.lines.classes.add(LineClass::detail);
    request.lines.quality = Quality::exact;
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, request, run);
    double length = 0;
    const StrokeModel& strokes = *drawn.visibility().result.strokes;
    for (const Stroke& s : strokes.strokes)
      if (s.line_class == LineClass::detail)
        length += glm::distance(strokes.lattice.to_mm(s.from), strokes.lattice.to_mm(s.to));
    EXPECT_NEAR(length, first + second, kLength) << method->traits().name;
  }
}

/// Regions that are seen through a region, as (face, level).
TEST(Transparency, EveryRegionListsWhatIsSeenThroughIt) {
  using Place = std::pair<std::uint32_t, std::uint32_t>;
  const Seen seen("transparent_layers.json", "front");
  const Lattice lattice = page_lattice(seen.view);
  const auto through = seen_through(seen.scene, seen.regions, lattice);
  ASSERT_EQ(through.size(), seen.regions.size());
  const std::uint32_t wall = 0, red = 1, blue = 2;
  const std::map<Place, std::set<Place>> wanted{{{wall, 0}, {}},         {{wall, 1}, {}},
                                                {{wall, 2}, {}},         {{red, 0}, {{wall, 1}}},
                                                {{red, 1}, {{wall, 2}}}, {{blue, 0}, {{red, 1}, {wall, 1}}}};
  std::map<Place, std::set<Place>> found;
  for (std::size_t i = 0; i < seen.regions.size(); ++i) {
    auto& list = found[{seen.regions[i].face, seen.regions[i].level}];
    for (const std::uint32_t k : through[i]) list.insert({seen.regions[k].face, seen.regions[k].level});
  }
  EXPECT_EQ(found, wanted);
  EXPECT_TRUE(seen_through(seen.scene, {}, lattice).empty());
}

}  // namespace
}  // namespace ligne
