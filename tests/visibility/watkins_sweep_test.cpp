// The exact scan: its stops, its bands.

#include "linework/overlaps/stroke_overlap.hpp"
#include "scene/clean/clean.hpp"
#include "support/scenes.hpp"
#include "visibility/watkins/exact/exact_study.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

struct Prepared {
  ProjectedScene projected;
  Facets facets;
  std::vector<SweepLine> lines;
};

Prepared prepare(Scene scene, const CameraRequest& camera) {
  Warnings warnings;
  finish_scene(scene, warnings);
  Prepared p{project_on_a4(scene, camera), {}, {}};
  p.facets = make_facets(p.projected, 1);
  for (const ProjectedEdge& e : p.projected.edges)
    p.lines.push_back({p.projected.vertices[e.v0], p.projected.vertices[e.v1], e.face0, e.face1});
  return p;
}

ExactResult study(const Prepared& p, SpanMethodKind kind = SpanMethodKind::stack, bool penetrations = false) {
  ExactOptions options;
  options.kind = kind;
  options.coincidence_steps = 30;
  options.penetrations = penetrations;
  return study_exactly(p.projected.vertices, p.facets.facets, p.lines, options);
}

/// Two plates, one before the other, turned: ten stops for the eight corners and two diagonals' ends, crossings where sides
/// and diagonals cross.
TEST(WatkinsSweep, StopsOfTwoPlates) {
  const Scene scene =
      scene_of_faces({{{0, 0, 0}, {10, 0, 1}, {11, 0, 11}, {1, 0, 10}}, {{3, 5, 2}, {20, 5, 3}, {21, 5, 8}, {4, 5, 7}}});
  const Prepared p = prepare(scene, along({0, 1, 0}));
  const ExactResult r = study(p);
  EXPECT_EQ(r.counts.sweep.points, 8u);
  EXPECT_EQ(r.counts.sweep.searches, 2u);  // only the highest corner of each plate hangs in the air
  // The two long sides of the plate behind cross the right side of the one before; and diagonals cross what they cross.
  EXPECT_GE(r.counts.sweep.crossings, 2u);
  EXPECT_LE(r.counts.sweep.crossings, 8u);
  OpenParts open;
  int parts = 0, hidden = 0;
  for (std::size_t i = 0; i < p.lines.size(); ++i) {
    const auto& found = r.found.visible_parts(i, open);
    parts += static_cast<int>(found.size());
    hidden += found.empty();
  }
  EXPECT_EQ(hidden, 1);  // the short side behind the plate
  EXPECT_EQ(parts, 7);
}

/// Intervals do not depend on the span method that proposes the facets, and none is missing against a test of every facet.
TEST(WatkinsSweep, FindingsAreThoseOfAllFacets) {
  const Prepared p = prepare(random_boxes(40, 11, 6, {3, 2, 2.5}), along({-1, 2, -1}));
  OpenParts open, all;
  for (const SpanMethodKind kind :
       {SpanMethodKind::merge, SpanMethodKind::stack, SpanMethodKind::box, SpanMethodKind::point}) {
    const ExactResult r = study(p, kind);
    EXPECT_GT(r.counts.stretches.studied, 0u);
    for (std::size_t i = 0; i < p.lines.size(); ++i) {
      const SweepLine& l = p.lines[i];
      if (l.from.p == l.to.p) continue;
      const PageLine line(l.from, l.to, l.face0, l.face1);
      all.reset(0, 1);
      bool near_side = false;
      for (const Facet& f : p.facets.facets) {
        if (f.face == l.face0 || f.face == l.face1 || all.empty()) continue;
        all.take(hidden_interval(line, f, p.projected.vertices.data(), {0, 1}, 0, near_side));
      }
      const std::vector<LinePart> expected = all.finish();
      const std::vector<LinePart>& found = r.found.visible_parts(i, open);
      double expected_length = 0, found_length = 0;
      for (const LinePart& part : expected) expected_length += part.to - part.from;
      for (const LinePart& part : found) found_length += part.to - part.from;
      ASSERT_NEAR(found_length, expected_length, 1e-9) << "line " << i;
    }
    EXPECT_LT(r.counts.stretches.facet_tests, p.lines.size() * p.facets.facets.size() / 4);
  }
}

/// Every edge seen is found in some band; the bands are made of the scene alone, and hold every point once.
TEST(WatkinsSweep, BandsHoldEveryPointOnce) {
  Scene scene;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k) add_box(scene, {1.5 * i, 1.5 * k, 0.1 * ((i * 7 + k * 3) % 10)}, {1, 1, 1});
  const Prepared p = prepare(scene, along({-1, 2, -1}));
  const SweepScene sweep = make_sweep_scene(p.projected.vertices, p.facets.facets, p.lines);
  const std::vector<SweepBand> bands = make_bands(sweep);
  ASSERT_GT(bands.size(), 1u);
  std::uint32_t next = 0;
  for (const SweepBand& b : bands) {
    EXPECT_EQ(b.first, next);
    next = b.end;
    for (const std::uint32_t e : b.active) {
      EXPECT_LT(sweep.edges[e].top_point, b.first);
      EXPECT_GE(sweep.edges[e].bottom_point, b.first);
    }
  }
  EXPECT_EQ(next, sweep.points.size());
  for (std::size_t i = 1; i < sweep.points.size(); ++i) ASSERT_TRUE(comes_before(sweep.points[i - 1], sweep.points[i]));
}

/// Boxes in boxes seen along their diagonal: no facet covers the cells on the edges of the outermost one, but its faces do
/// together, and the scan meets nothing of the others.
TEST(WatkinsSweep, LeavesOutWhatConnectedFacetsHideTogether) {
  constexpr int kBoxes = 400;
  Scene scene;
  for (int k = 1; k <= kBoxes; ++k) {
    const double r = 1 + double(k) / kBoxes;
    add_box(scene, {-r, -r, -r}, {2 * r, 2 * r, 2 * r});
  }
  const Prepared p = prepare(scene, along({-1, 1, -1}));
  const Statistics counts = find_method("watkins")->compute_visibility(p.projected, {}).statistics;
  const auto count = [&](std::string_view name) { return count_of(counts, name); };
  EXPECT_EQ(count("facets"), 12u * kBoxes);
  EXPECT_GT(count("facets in front of all covers"), 0u);
  EXPECT_LT(count("facets in front of all covers"), 12u * kBoxes / 8);
}

/// Length of all visible strokes of the scene, by class.
std::array<double, kLineClassCount> visible_lengths(const ProjectedScene& scene, const char* method) {
  VisibilityResult result = find_method(method)->compute_visibility(scene, {});
  remove_coincident_strokes(*result.strokes, coincidence_mm(scene));
  std::array<double, kLineClassCount> lengths{};
  for (const Stroke& s : result.strokes->strokes)
    if (s.visible) lengths[static_cast<std::size_t>(s.line_class)] += length(s.from, s.to);
  return lengths;
}

/// Hundreds of facets over each other on all of the page: the scan gives up, and the lines are studied by cells.
TEST(WatkinsSweep, GivesUpInACrowd) {
  constexpr int kSquares = 300;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0, 3), size(1, 5);
  Scene sheets, fan;
  for (int k = 0; k < kSquares; ++k) {
    const double x = place(random), y = place(random), w = size(random), h = size(random);
    add_face(sheets, {{{x, y, 0}, {x + w, y, 0}, {x + w, y + h, 0}, {x, y + h, 0}}});
    const double a = 3.14159265358979 * k / kSquares, u = std::cos(a), v = std::sin(a);
    add_face(fan, {{{0, 0, 0}, {u, v, 0}, {u, v, 1}, {0, 0, 1}}});
  }
  for (Scene* scene : {&sheets, &fan}) {
    const Prepared p = prepare(*scene, along({-1, 1, -1}));
    EXPECT_TRUE(study(p, SpanMethodKind::stack, true).gave_up);
    const auto expected = visible_lengths(p.projected, "appel"), found = visible_lengths(p.projected, "watkins");
    for (std::size_t c = 0; c < kLineClassCount; ++c) EXPECT_NEAR(found[c], expected[c], 1e-6 * expected[c]);
  }
  Scene boxes;
  for (int i = 0; i < kSquares; ++i) add_box(boxes, {place(random), place(random), place(random)}, {size(random), 0.3, 0.2});
  EXPECT_FALSE(study(prepare(boxes, along({-1, 1, -1})), SpanMethodKind::stack, true).gave_up);
}

}  // namespace
}  // namespace ligne::watkins
