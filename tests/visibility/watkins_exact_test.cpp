/// The exact scan, and the span methods by hand and against each other.

#include "geometry/segment_overlap.hpp"
#include "support/scenes.hpp"
#include "visibility/watkins/exact/exact_study.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

// The exact scan: its stops, its bands.

struct Prepared {
  ProjectedScene projected;
  Facets facets;
  std::vector<SweepLine> lines;
};

Prepared prepare(Scene scene, const CameraRequest& camera) {
  finish(scene);
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

/// Whatever span method proposes the facets, a line is held against few of them.
TEST(WatkinsSweep, HoldsALineAgainstFewFacets) {
  const Prepared p = prepare(random_boxes(40, 11, 6, {3, 2, 2.5}), along({-1, 2, -1}));
  for (const SpanMethodKind kind :
       {SpanMethodKind::merge, SpanMethodKind::stack, SpanMethodKind::box, SpanMethodKind::point}) {
    const ExactResult r = study(p, kind);
    EXPECT_GT(r.counts.stretches.studied, 0u);
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

// The span methods by hand, and against each other. LimitedMethods hold the lines of all of them against the oracle.

template <class X>
using Segments = std::vector<ScanSegment<X>>;

constexpr SpanMethodKind kKinds[] = {SpanMethodKind::merge, SpanMethodKind::stack, SpanMethodKind::box,
                                     SpanMethodKind::point, SpanMethodKind::remembered};

template <class X>
std::vector<VisibleSpan> spans(SpanMethodKind kind, Segments<X> segments, SpanCounts* counts = nullptr) {
  const auto method = make_span_method<X>(kind);
  std::vector<VisibleSpan> out{{0, 1, 77}};  // what was there before goes
  method->study(segments, out);
  if (counts) *counts = method->counts();
  return out;
}

template <class X>
class WatkinsSpans : public testing::Test {};
using Coordinates = testing::Types<double, std::int32_t>;
TYPED_TEST_SUITE(WatkinsSpans, Coordinates);

/// Figure 2.45: one long segment behind, two short ones before it.
TYPED_TEST(WatkinsSpans, FigureOfTheThesis) {
  const Segments<TypeParam> segments{{0, 10, 5, 5, 0}, {1, 4, 2, 2, 1}, {3, 8, 1, 3, 2}};
  for (const SpanMethodKind kind : kKinds) {
    const auto found = spans(kind, segments);
    std::vector<std::pair<std::uint32_t, double>> ends;
    for (const VisibleSpan& s : found) ends.emplace_back(s.segment, s.x1);
    EXPECT_EQ(ends, (std::vector<std::pair<std::uint32_t, double>>{{0, 1}, {1, 3}, {2, 8}, {0, 10}}))
        << static_cast<int>(kind);
  }
}

/// A screen segment hides everything: the box method sees that at once, the stack goes through all ([Boulle1980] end
/// of 2.3.3.4).
TYPED_TEST(WatkinsSpans, ScreenSegmentIsTheBoxMethodsBest) {
  Segments<TypeParam> segments{{0, 1000, -1, -1, 0}};
  for (int i = 0; i < 100; ++i)
    segments.push_back(
        {static_cast<TypeParam>(10 * i), static_cast<TypeParam>(10 * i + 9), 5, 5, static_cast<std::uint32_t>(i + 1)});
  SpanCounts box, stack;
  ASSERT_EQ(spans(SpanMethodKind::box, segments, &box).size(), 1u);
  ASSERT_EQ(spans(SpanMethodKind::stack, segments, &stack).size(), 1u);
  EXPECT_EQ(box.boxes, 1u);
  EXPECT_LT(box.total(), stack.total());
}

/// Divisions of the line before, moved to where their segments are now: right while the segments move, cross, vanish and
/// come back, and fewer parts than without memory.
TYPED_TEST(WatkinsSpans, RememberedDivisionsFollowTheirSegments) {
  std::mt19937 random(95);
  std::uniform_int_distribution<int> place(0, 400), length(5, 60), depth(0, 1000), step(-2, 2);
  struct Moving {
    int x, length, z0, z1, dx, dz;
  };
  std::vector<Moving> moving;
  for (int i = 0; i < 60; ++i)
    moving.push_back({place(random), length(random), depth(random), depth(random), step(random), step(random)});
  const auto remembered = make_span_method<TypeParam>(SpanMethodKind::remembered);
  const auto box = make_span_method<TypeParam>(SpanMethodKind::box);
  for (int line = 0; line < 200; ++line) {
    Segments<TypeParam> segments;
    for (std::uint32_t key = 0; key < moving.size(); ++key) {
      Moving& m = moving[key];
      m.x += m.dx;
      m.z0 += m.dz;
      if ((line / 20 + static_cast<int>(key)) % 5 == 0) continue;  // not on this line
      segments.push_back({static_cast<TypeParam>(m.x), static_cast<TypeParam>(m.x + m.length), double(m.z0), double(m.z1),
                          static_cast<std::uint32_t>(segments.size()), key});
    }
    std::vector<VisibleSpan> found, plain;
    remembered->study(segments, found);
    box->study(segments, plain);
    ASSERT_EQ(found.size(), plain.size()) << line;
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].segment, plain[i].segment) << line;
      ASSERT_NEAR(found[i].x0, plain[i].x0, 1e-6) << line;
      ASSERT_NEAR(found[i].x1, plain[i].x1, 1e-6) << line;
    }
  }
  EXPECT_GT(remembered->counts().remembered, 1000u);
  EXPECT_LT(remembered->counts().boxes, box->counts().boxes);
  EXPECT_EQ(box->counts().remembered, 0u);
}

/// Says of any two segments that the one of the higher number is in front.
class HigherFirst final : public PairOrders {
 public:
  DepthOrder of(std::uint32_t a, std::uint32_t b) override { return a > b ? DepthOrder::first : DepthOrder::second; }
};

/// Where segments touch, their pair says who is in front, whatever the depths, in all methods; where they do not, the depths
/// say it.
TEST(WatkinsSpans, SegmentsThatTouchAreAsTheirPairSays) {
  const double touch = 0.01;
  // Two that cross by half the tolerance all along, one far in front of both, one far behind, in all orders.
  const Segments<double> all{{0, 10, 1 - 0.003, 1 + 0.003, 0, 0, touch},
                             {2, 12, 1 + 0.002, 1 - 0.002, 1, 0, touch},
                             {4, 5, 0.5, 0.5, 2, 0, touch},
                             {1, 11, 2, 2, 3, 0, touch}};
  std::array<std::uint32_t, 4> turn{0, 1, 2, 3};
  do {
    Segments<double> segments;
    for (const std::uint32_t i : turn) segments.push_back(all[i]);
    for (const SpanMethodKind kind : kKinds) {
      const auto method = make_span_method<double>(kind);
      HigherFirst higher_first;
      method->ask(&higher_first);
      std::vector<VisibleSpan> found;
      method->study(segments, found);
      std::vector<std::array<double, 3>> seen;
      for (const VisibleSpan& s : found) seen.push_back({s.x0, s.x1, double(segments[s.segment].face)});
      const std::vector<std::array<double, 3>> expected{{0, 2, 0}, {2, 4, 1}, {4, 5, 2}, {5, 12, 1}};
      EXPECT_EQ(seen, expected) << kSpanMethodNames[static_cast<std::size_t>(kind)];
    }
  } while (std::next_permutation(turn.begin(), turn.end()));
}

}  // namespace
}  // namespace ligne::watkins
