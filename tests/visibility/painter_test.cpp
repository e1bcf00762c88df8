// The painter: orders by hand, the cases that planes decide, rings and penetration, faces of one depth each. What it paints:
// zbuffer_test.cpp.

#include "report/stroke_difference.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "visibility/painter/paint_sequence.hpp"

namespace ligne::test {
namespace {

using namespace painter;

PaintSequence sequence_of(const ProjectedScene& scene, DepthSort sort) {
  const double coincidence = coincidence_mm(scene) / scene.lattice.step_mm;
  const Facets facets = make_facets(scene, coincidence);
  CellGrid::Options options;
  options.margin_steps = coincidence + 1;
  options.drop_hidden = false;
  return paint_sequence(scene, facets.facets, CellGrid(scene, facets.facets, options), sort);
}

/// Along +y, z up: y is the depth.
CameraRequest front() { return along({0, 1, 0}); }

using Faces = std::vector<std::uint32_t>;

/// Face 0 is a slope, face 1 a plate behind it and nearer than its far end, face 2 a plate before it and farther than its
/// mean.
TEST(Painter, APlaneTellsWhatDepthsDoNot) {
  // A slope, z = y / 2; below it, so behind; above it, so in front.
  const Scene scene = scene_of_faces({{{0, 0, 0}, {100, 0, 0}, {100, 100, 50}, {0, 100, 50}},
                                      {{20, 30, 0}, {40, 30, 0}, {40, 30, 10}, {20, 30, 10}},
                                      {{60, 60, 40}, {80, 60, 40}, {80, 60, 50}, {60, 60, 50}}});
  const ProjectedScene page = project_on_a4(scene, front());
  // Means 50, 30, 60; farthest 100, 30, 60.
  EXPECT_EQ(sequence_of(page, DepthSort::mean).faces, (Faces{2, 0, 1}));
  EXPECT_EQ(sequence_of(page, DepthSort::mean).wrong, 2u);
  EXPECT_EQ(sequence_of(page, DepthSort::farthest).faces, (Faces{0, 2, 1}));
  EXPECT_EQ(sequence_of(page, DepthSort::farthest).wrong, 1u);
  const PaintSequence resolved = sequence_of(page, DepthSort::resolved);
  EXPECT_EQ(resolved.faces, (Faces{1, 0, 2}));
  EXPECT_EQ(resolved.by_planes, 2u);
  EXPECT_EQ(resolved.wrong, 0u);
  EXPECT_EQ(find_method("painter")->compute_visibility(page, {}).unsupported_reason, "");
}

/// Lines are hidden by what is painted later, and by nothing else. By hand: the near plate, 4 wide, stands over the right
/// side of the far one, 10 wide. All 16 of the near one are seen, and of the 40 of the far one all but 4.
TEST(Painter, WhatIsPaintedLaterCovers) {
  const Scene scene =
      scene_of_faces({{{0, 5, 0}, {10, 5, 0}, {10, 5, 10}, {0, 5, 10}}, {{8, 0, 3}, {12, 0, 3}, {12, 0, 7}, {8, 0, 7}}});
  EXPECT_NEAR(draw(scene, {front(), "all", false, 1, "painter"}).length(), 16 + 36, 1e-3);
  EXPECT_NEAR(draw(scene, {front(), "all", true, 1, "painter"}).length(false), 4, 1e-3) << "what is hidden";
}

/// Cartography, circuits, windows: the trivial case needs no pairs.
TEST(Painter, FacesOfOneDepthEach) {
  Scene scene;
  for (int i = 0; i < 20; ++i) {
    const double x = 7 * i % 30, y = (11 * i) % 20;
    add_face(scene, {{{x, y, x}, {x + 40, y, x}, {x + 40, y, x + 30}, {x, y, x + 30}}});
  }
  const PaintSequence sequence = sequence_of(project_on_a4(scene, front()), DepthSort::resolved);
  EXPECT_TRUE(sequence.level);
  EXPECT_EQ(sequence.overlapping, 0u);
  ASSERT_EQ(sequence.faces.size(), 20u);
  for (std::size_t i = 1; i < 20; ++i) EXPECT_GE((11 * sequence.faces[i - 1]) % 20, (11 * sequence.faces[i]) % 20);
}

/// Figure 2.81 of the thesis: a, b are resolved, c penetrates, d overlaps mutually, e in a ring.
TEST(Painter, FiguresOfTheThesis) {
  const auto sequence = [](const char* name) {
    return sequence_of(project_on_a4(corpus_scene(name), front()), DepthSort::resolved);
  };
  for (const char* name : {"thesis_2_72", "thesis_2_81a", "thesis_2_81b"})
    EXPECT_EQ(sequence(name).wrong + sequence(name).penetrating + sequence(name).left, 0u) << name;
  EXPECT_EQ(sequence("thesis_2_81c").penetrating, 1u);
  EXPECT_EQ(sequence("thesis_2_81d").penetrating, 1u);
  const PaintSequence ring = sequence("thesis_2_81e");
  EXPECT_GT(ring.wrong, 0u);
  EXPECT_EQ(ring.penetrating, 0u);
  for (const char* name : {"cyclic_3", "cyclic_4", "cyclic_5", "cyclic_6"}) {
    EXPECT_EQ(sequence(name).wrong, 1u) << name;
    EXPECT_EQ(sequence(name).penetrating, 0u) << name;
  }
}

/// The viewer stands in the room: faces reach from before the eye to behind it.
TEST(Painter, FromAmongTheFacesWhatIsBehindTheViewerIsCutOff) {
  const ProjectedScene page = project_on_a4(corpus_scene("room"), from_eye({1.5, 3.25, 6.5}, {9, 11, 2}, 80));
  ASSERT_FALSE(page.edge_parts.empty()) << "nothing is cut off";
  const VisibilityResult painted = find_method("painter")->compute_visibility(page, {}),
                         truth = find_method("appel")->compute_visibility(page, {});
  EXPECT_EQ(painted.unsupported_reason, "");
  EXPECT_GT(truth.strokes->strokes.size(), 10u);
  EXPECT_TRUE(parts_missing(*truth.strokes, *painted.strokes).empty());
  EXPECT_TRUE(parts_missing(*painted.strokes, *truth.strokes).empty());
}

TEST(Painter, WithTheEyeOnACornerItSaysThatItMayBeWrong) {
  const CameraRequest corner = from_eye({0, 0, 0}, {9, 11, 2});
  EXPECT_NE(find_method("painter")->compute_visibility(project_on_a4(corpus_scene("room"), corner), {}).unsupported_reason,
            "");
}

}  // namespace
}  // namespace ligne::test
