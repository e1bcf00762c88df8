// Skew faces by the slopes of their sides: ends of lines, curves and spans worked out by hand on the ruled surface, and
// plane faces against their triangles.

#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
#include "visibility/watkins/skew_faces.hpp"

namespace ligne::watkins::skew_test {
namespace {

using namespace ligne::test;

/// A square of 80 with one corner raised by 40: between its left and right sides the height is x y / 160.
const std::vector<Point3> kTwisted = {{0, 0, 0}, {80, 0, 0}, {80, 80, 40}, {0, 80, 0}};

/// Across it at the height 10.
const std::vector<Point3> kPlate = {{-5, 30, 10}, {85, 30, 10}, {85, 50, 10}, {-5, 50, 10}};

Scene with_twisted(const std::vector<std::vector<Point3>>& others) {
  std::vector<std::vector<Point3>> faces = {kTwisted};
  faces.insert(faces.end(), others.begin(), others.end());
  Scene scene = scene_of_faces(faces);
  finish(scene);
  return scene;
}

ProjectedScene from_above(const Scene& scene) {
  const View view = make_view(scene, make_camera(along({0, 0, -1}), scene), {{{0, 0}, {120, 120}}}, {{0, 0}, {120, 120}}, 1);
  return project(scene, build_topology(scene), view, {classes("all"), 30});
}

VisibilityResult study(const ProjectedScene& projected, bool slopes, unsigned lines = 500) {
  VisibilityOptions options;
  options.settings.set("lines", lines);
  if (slopes) options.settings.set("skew", ParameterWord{1});
  options.span_lines = SpanLines{0.05, 0.1, 1200};
  return find_method("watkins")->compute_visibility(projected, options);
}

/// Intervals in which the visible strokes that meet a condition run, by the x of the scene.
template <class Condition>
std::vector<std::array<double, 2>> visible_x(const VisibilityResult& result, Point2 origin, Condition holds) {
  std::vector<std::array<double, 2>> parts;
  for (const Stroke& s : result.strokes->strokes) {
    const Point2 a = result.strokes->lattice.to_mm(s.from), b = result.strokes->lattice.to_mm(s.to);
    const Point2 p{a.x - origin.x, origin.y - a.y}, q{b.x - origin.x, origin.y - b.y};
    if (s.visible && holds(p, q)) parts.push_back({std::min(p.x, q.x), std::max(p.x, q.x)});
  }
  std::ranges::sort(parts);
  return parts;
}

/// The page place of the scene's origin.
Point2 origin_of(const ProjectedScene& projected) { return page_point(projected.view, {0, 0, 0}); }

constexpr double kLatticeMm = 1e-5;

/// A plate at the height 10 with two edges across the square. On the ruled surface an edge at y is hidden where x > 1600 /
/// y; on triangles the diagonal from (0, 0) to (80, 80), or the other, bends the surface, and the ends are elsewhere.
TEST(SkewFaces, HideByTheRuledSurface) {
  const Scene scene = with_twisted({kPlate});
  ASSERT_EQ(scene.faces.size(), 3u) << "the reader cuts the square in two";
  const ProjectedScene projected = from_above(scene);
  const Point2 origin = origin_of(projected);
  const VisibilityResult slopes = study(projected, true), triangles = study(projected, false);
  for (const double y : {30.0, 50.0}) {
    const auto at_y = [&](Point2 p, Point2 q) { return std::abs(p.y - y) < kLatticeMm && std::abs(q.y - y) < kLatticeMm; };
    const auto parts = visible_x(slopes, origin, at_y), cut = visible_x(triangles, origin, at_y);
    ASSERT_EQ(parts.size(), 2u) << y;
    EXPECT_NEAR(parts[0][0], -5, kLatticeMm);
    EXPECT_NEAR(parts[0][1], 1600 / y, kLatticeMm);
    EXPECT_NEAR(parts[1][0], 80, kLatticeMm);
    EXPECT_NEAR(parts[1][1], 85, kLatticeMm);
    ASSERT_EQ(cut.size(), 2u);
    EXPECT_GT(std::abs(cut[0][1] - 1600 / y), 5) << "triangles end elsewhere";
  }
}

/// Along an oblique edge the depth of the surface is quadratic: it hides the middle, or both ends.
TEST(SkewFaces, HideObliqueEdges) {
  // From (0, 78) to (78, 0) at the height 8: x (78 - x) / 160 > 8 in the middle.
  const Scene scene = with_twisted({{{0, 78, 8}, {78, 0, 8}, {-40, -40, 8}}});
  const ProjectedScene projected = from_above(scene);
  const auto parts = visible_x(study(projected, true), origin_of(projected), [](Point2 p, Point2 q) {
    return std::abs(p.x + p.y - 78) < kLatticeMm && std::abs(q.x + q.y - 78) < kLatticeMm;
  });
  const double half = std::sqrt(39 * 39 - 8 * 160);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0][1], 39 - half, kLatticeMm);
  EXPECT_NEAR(parts[1][0], 39 + half, kLatticeMm);

  // From (0, 0) to (80, 80), at the height x / 5 - 1: x^2 / 160 is higher at both ends.
  const Scene other = with_twisted({{{0, 0, -1}, {80, 80, 15}, {-40, 100, -20}}});
  const ProjectedScene page = from_above(other);
  const auto middle = visible_x(study(page, true), origin_of(page), [](Point2 p, Point2 q) {
    return std::abs(p.x - p.y) < kLatticeMm && std::abs(q.x - q.y) < kLatticeMm;
  });
  ASSERT_EQ(middle.size(), 1u);
  EXPECT_NEAR(middle[0][0], 16 - std::sqrt(96), kLatticeMm);
  EXPECT_NEAR(middle[0][1], 16 + std::sqrt(96), kLatticeMm);
}

/// The plate at the height 10 penetrates along x y = 1600, drawn from line to line.
TEST(SkewFaces, PenetrateAlongCurves) {
  const Scene scene = with_twisted({kPlate});
  const ProjectedScene projected = from_above(scene);
  const Point2 origin = origin_of(projected);
  const VisibilityResult result = study(projected, true);
  double length = 0, lowest = 1e300, highest = -1e300;
  for (const Stroke& s : result.strokes->strokes) {
    if (s.line_class != LineClass::intersection || !s.visible) continue;
    const Point2 a = result.strokes->lattice.to_mm(s.from), b = result.strokes->lattice.to_mm(s.to);
    for (const Point2 p : {a, b}) {
      const double x = p.x - origin.x, y = origin.y - p.y;
      EXPECT_NEAR(x * y, 1600, 1e-3);
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    length += glm::length(b - a);
  }
  constexpr double kLine = 120.0 / 500;
  EXPECT_NEAR(lowest, 30, kLine);
  EXPECT_NEAR(highest, 50, kLine);
  EXPECT_NEAR(length, std::hypot(1600.0 / 30 - 1600.0 / 50, 20), 3 * kLine) << "hardly longer than its chord";
}

/// The spans of a line change at the same places.
TEST(SkewFaces, SpansEndOnTheRuledSurface) {
  const Scene scene = with_twisted({kPlate});
  const ProjectedScene projected = from_above(scene);
  const Point2 origin = origin_of(projected);
  const VisibilityResult result = study(projected, true);
  std::size_t lines = 0;
  for (std::size_t i = 0; i < result.spans->spans.size(); ++i) {
    const Span& span = result.spans->spans[i];
    const double y = origin.y - result.spans->lines.y_mm(span.line);
    if (span.face != 2 || y < 30.2 || y > 49.8 || span.x_from - origin.x > 0) continue;
    ++lines;
    EXPECT_NEAR(span.x_to - origin.x, 1600 / y, 1e-6);
    ASSERT_LT(i + 1, result.spans->spans.size());
    EXPECT_EQ(result.spans->spans[i + 1].face, 0u) << "the whole square has one number";
  }
  EXPECT_GT(lines, 150u);
}

/// Plane faces stay as they are: a scene without skew faces gives the strokes of its triangles.
TEST(SkewFaces, PlaneFacesDoNotChange) {
  for (const char* name : {"bricks", "house", "cyclic_5", "two_prisms_penetrating"}) {
    const Scene scene = corpus_scene(name);
    const ProjectedScene projected = project_on_a4(scene, along({-0.31, 0.87, -0.39}));
    EXPECT_FALSE(join_skew_faces(projected, {})) << name;
    const auto a = study(projected, true), b = study(projected, false);
    ASSERT_EQ(a.strokes->strokes.size(), b.strokes->strokes.size()) << name;
    for (std::size_t i = 0; i < a.strokes->strokes.size(); ++i) {
      EXPECT_EQ(a.strokes->strokes[i].from, b.strokes->strokes[i].from);
      EXPECT_EQ(a.strokes->strokes[i].to, b.strokes->strokes[i].to);
    }
  }
}

std::vector<RuledSide> sides_between(const std::vector<ProjectedVertex>& corners) {
  std::vector<RuledSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ProjectedVertex a = corners[i], b = corners[(i + 1) % corners.size()];
    if (a.p.y > b.p.y) std::swap(a, b);
    if (a.p.y < b.p.y) sides.push_back({a, b});
  }
  return sides;
}

/// Depth of the surface at a point, if it is over the parts.
std::optional<double> depth_over(const std::vector<RuledPart>& parts, double x, double y) {
  for (const RuledPart& part : parts) {
    if (y < part.y_top || y >= part.y_bottom) continue;
    const double a = x - part.left.x(y), b = part.right.x(y) - x;
    if (a >= 0 && b >= 0) return (part.left.z(y) * b + part.right.z(y) * a) / (a + b);
  }
  return std::nullopt;
}

/// Lines against random polygons, also reentrant and crossing themselves, by points along them.
TEST(RuledParts, LinesAreHiddenWhereTheyAreFarther) {
  std::mt19937 random(5);
  std::uniform_int_distribution<std::int32_t> place(-1000, 1000);
  std::uniform_real_distribution<double> depth(-100, 100);
  const auto vertex = [&] { return ProjectedVertex{{place(random), place(random)}, depth(random)}; };
  std::size_t hidden_points = 0, points = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<ProjectedVertex> corners(3 + static_cast<std::size_t>(round) % 4);
    for (ProjectedVertex& c : corners) c = vertex();
    const std::vector<RuledPart> parts = ruled_parts(sides_between(corners));
    ProjectedVertex from = vertex(), to = vertex();
    if (round % 5 == 0) to.p.y = from.p.y;
    const PageLine line(from, to, kNone, kNone);
    std::vector<HiddenInterval> hidden;
    for (const RuledPart& part : parts)
      for (const HiddenInterval& h : behind_ruled_part(line, part, 1e-9))
        if (h.sides != HiddenSides::none) hidden.push_back(h);
    for (double t = 0.003; t < 1; t += 0.01) {
      const double x = line.p0.x + t * line.dx, y = line.p0.y + t * line.dy;
      const auto surface = depth_over(parts, x, y);
      if (surface && std::abs(line.z(t) - *surface) < 1e-6) continue;
      const bool expected = surface && line.z(t) > *surface;
      const bool is_hidden =
          std::ranges::any_of(hidden, [&](const HiddenInterval& h) { return h.from - 1e-9 <= t && t <= h.to + 1e-9; });
      const bool inside =
          std::ranges::any_of(hidden, [&](const HiddenInterval& h) { return h.from + 1e-9 < t && t < h.to - 1e-9; });
      ++points;
      hidden_points += expected;
      if (is_hidden != inside) continue;  // at an end
      ASSERT_EQ(is_hidden, expected) << round << ' ' << t;
    }
  }
  EXPECT_GT(hidden_points, points / 20);
}

/// A line along a side, behind it, is covered on the side of the face alone, as by a facet.
TEST(RuledParts, ALineAlongASideIsCoveredOnOneSide) {
  const std::vector<ProjectedVertex> corners = {{{0, 0}, 0}, {{100, 0}, 1}, {{90, 100}, 2}, {{10, 100}, 0}};
  const std::vector<RuledPart> parts = ruled_parts(sides_between(corners));
  ASSERT_EQ(parts.size(), 1u);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ProjectedVertex &a = corners[i], &b = corners[(i + 1) % corners.size()];
    for (const bool turned : {false, true}) {
      const PageLine line({turned ? b.p : a.p, 50}, {turned ? a.p : b.p, 50}, kNone, kNone);
      // The corners turn clockwise on the page, so the face lies to the left of its sides as hidden_interval() counts.
      const Facet facet{{0, 1, 2}, 0, 0, 2, 0, 200};
      const ProjectedVertex around[3] = {a, b, {{50, 50}, 1}};
      bool near_side = false;
      const HiddenInterval by_facet = hidden_interval(line, facet, around, {0, 1}, 0, near_side);
      const HiddenInterval h = behind_ruled_part(line, parts[0], 1e-9)[0];
      EXPECT_EQ(h.sides, by_facet.sides) << i << turned;
      EXPECT_EQ(h.from, 0);
      EXPECT_EQ(h.to, 1);
    }
  }
}

}  // namespace
}  // namespace ligne::watkins::skew_test
