// Smooth contours: what they leave alone, and what must not change them.

#include "base/parallel.hpp"
#include "contours/contour_junctions.hpp"
#include "contours/parametric_mesh.hpp"
#include "contours/surfaces/smooth_patch.hpp"
#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "patches/patch_scenes.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;
const Point3 kIso{-1, 1, -1};

void expect_same(const Polylines& a, const Polylines& b) {
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_TRUE(std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                         [](Point2 p, Point2 q) { return p.x == q.x && p.y == q.y; }));
}

/// A body of revolution with flat ends: rings of `sides` vertices at the radii, 10 apart. A radius of 0 is a tip.
Scene turned(int sides, const std::vector<double>& radii) {
  const std::string n = std::to_string(sides), angle = "(2*pi*(u+0.37)/" + n + ")";
  std::string radius = "0";
  for (std::size_t r = 0; r < radii.size(); ++r)
    radius = "if(v==" + std::to_string(r) + "," + as_text(radii[r]) + "," + radius + ")";
  return mesh_of("grid " + n + " x " + std::to_string(radii.size() - 1) + " capped triangles round: " + radius + "*cos" +
                 angle + "; " + radius + "*sin" + angle + "; 10*v\nwithout doubled\nexact")
      .scene();
}

/// Without creases of its own: borders of regions by the angle.
DrawnOutlines by_angle(const Scene& scene, bool smooth) { return draw_outlines(scene, kIso, smooth, true); }

/// The edges between these pairs of vertices of `turned`, which are numbered ring by ring, ascending.
std::vector<std::uint32_t> edges_between(const Scene& scene, const Topology& topology,
                                         const std::vector<std::pair<std::uint32_t, std::uint32_t>>& ends) {
  const auto number = [&](std::uint32_t v) {
    const Point3 p = scene.vertices[v];
    const auto place = std::lround(24 * (std::atan2(p.y, p.x) / kTurn + 1) - 0.37) % 24;
    return static_cast<std::uint32_t>(std::lround(p.z / 10) * 24 + place);
  };
  std::vector<std::uint32_t> found;
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e)
    if (std::ranges::count(ends, std::minmax({number(topology.edges[e].v0), number(topology.edges[e].v1)})))
      found.push_back(e);
  return found;
}

TEST(SmoothPatch, LeavesOutOutlinesOfOneEdgeOnly) {
  const Scene cylinder = turned(24, {5, 5}), barrel = turned(24, {5, 5.2, 5});
  const auto inside = [](const Scene& scene, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& ends) {
    const Topology topology = build_topology(scene);
    const std::vector<std::uint32_t> edges = edges_between(scene, topology, ends);
    EXPECT_EQ(edges.size(), ends.size());
    return std::pair(outlines_inside_regions(scene, topology, edges, {}), edges);
  };
  EXPECT_TRUE(inside(cylinder, {{0, 24}, {12, 36}}).first.empty()) << "from rim to rim";
  EXPECT_TRUE(inside(cylinder, {{0, 1}}).first.empty()) << "a rim, where the region ends";
  for (const auto& [left, given] :
       {inside(barrel, {{0, 24}, {24, 48}}), inside(cylinder, {{0, 24}, {1, 25}}), inside(cylinder, {{0, 24}, {0, 25}})}) {
    EXPECT_EQ(left, given) << "one that continues it, or is a neighbour";
  }
}

TEST(SmoothContours, StraightOutlinesStayThoseOfTheMesh) {
  for (const int sides : {4, 8, 12, 24}) {
    const Scene cylinder = turned(sides, {30, 30}), rings = turned(sides, {30, 30, 30, 30}),
                cone = turned(sides, {30, 20, 10});
    for (const Scene* scene : {&cylinder, &rings, &cone})
      expect_same(by_angle(*scene, true).lines, by_angle(*scene, false).lines);
  }
}

TEST(SmoothContours, TheTipOfAConeStaysSharp) {
  const Scene cone = turned(24, {30, 0});
  expect_same(by_angle(cone, true).lines, by_angle(cone, false).lines);
}

TEST(SmoothContours, EndAtTheRimWhereTheOutlineOfTheMeshDoes) {
  const Scene barrel = turned(24, {25, 30, 33.66, 35, 33.66, 30, 25});
  const Polylines smooth = by_angle(barrel, true).lines, plain = by_angle(barrel, false).lines;
  EXPECT_EQ(smooth.size(), plain.size());
  EXPECT_GT(smooth.points.size(), plain.points.size());
  EXPECT_NEAR(length_of(smooth), length_of(plain), 0.01 * length_of(plain));
}

/// A box with fillets of radius 1 and `n` facets a quarter along all edges: half of its size without them.
Scene filleted_box(const Point3& half, int n) { return test::scene_of(rounded_box(half + Point3(1.0), n)); }

/// Means of normals would bend the flat sides, and the outline would bulge.
TEST(SmoothContours, FlatSidesWithRoundingsDoNotBulge) {
  for (const int steps : {3, 6}) {
    const Scene box = filleted_box({12.5, 10, 7.5}, steps);
    for (const Point3& direction : {Point3{-1, 0.06, -0.05}, Point3{-1, 0.2, -0.02}, Point3{-0.05, 1, -0.4}, kIso}) {
      const auto extent = [&](bool smooth) {
        Rect all;
        for (const Point2 p : draw_outlines(box, direction, smooth).lines.points) all.extend(p);
        return all;
      };
      const Rect contour = extent(true), mesh = extent(false);
      constexpr double kRise = 0.3;  // mm: what the facets of the roundings themselves are short of
      EXPECT_NEAR(contour.min.x, mesh.min.x, kRise) << steps << " " << direction.y;
      EXPECT_NEAR(contour.min.y, mesh.min.y, kRise) << steps << " " << direction.y;
      EXPECT_NEAR(contour.max.x, mesh.max.x, kRise) << steps << " " << direction.y;
      EXPECT_NEAR(contour.max.y, mesh.max.y, kRise) << steps << " " << direction.y;
    }
  }
}

TEST(SmoothContours, ACoarseRingSeenAlongItsAxisHasTwoClosedOutlines) {
  const Scene ring =
      uneven_mesh({"ring",
                   [](double u, double v) {
                     const double r = 30 + 12 * std::cos(kTurn * v);
                     return Point3{r * std::cos(kTurn * u), r * std::sin(kTurn * u), 12 * std::sin(kTurn * v)};
                   }},
                  30, 15, 0.2, 1);
  const Polylines lines = draw_outlines(ring, {0, 0, -1}).lines;
  ASSERT_EQ(lines.size(), 2u);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].front().x, lines[i].back().x);
    EXPECT_EQ(lines[i].front().y, lines[i].back().y);
  }
}

/// Flat sides stay flat, at every accuracy and along every axis: means of normals would make them bulge.
TEST(SmoothContours, FlatSidesBesideFilletsStayFlat) {
  const Point3 half{17.0 / 3, 4, 4.0 / 3};
  constexpr double kRadius = 1, kHalfPen = 0.175;
  for (const int n : {3, 6, 12}) {
    const Scene scene = filleted_box(half, n);
    for (const Point3& direction : {Point3{0, 0, -1}, Point3{0, 1, 0}, Point3{-1, 0, 0}}) {
      const DrawnOutlines drawn = draw_outlines(scene, direction);
      ASSERT_GT(drawn.lines.points.size(), 0u);
      // Extents along the axes of the model that lie in the page.
      for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] != 0) continue;
        Point3 end{0, 0, 0};
        end[axis] = half[axis] + kRadius;
        const Point2 to = page_point(drawn.view, end) - page_point(drawn.view, {0, 0, 0});
        double farthest = 0;
        for (const Point2 p : drawn.lines.points) {
          const Point2 at = p - page_point(drawn.view, {0, 0, 0});
          farthest = std::max(farthest, std::abs(glm::dot(at, to)) / glm::length(to));
        }
        const double sag = kRadius * (1 - std::cos(kTurn / 8 / n)) * drawn.view.scale;
        EXPECT_NEAR(farthest, glm::length(to), sag + kHalfPen) << n << " facets, axis " << axis;
      }
    }
  }
}

/// Lines behind the ball end at its contour, although the mesh, which hides them, is smaller: by more along the line than
/// across the strip between the two.
TEST(SmoothContours, LinesBehindThemEndThereAtAnyAngle) {
  constexpr double kRadius = 40;
  // Behind it a pyramid: its outline passes behind the ball at a small angle.
  const Scene scene = mesh_of(
                          "grid 28 x 15 round triangles: 40*cos(pi*(v/15-0.5))*cos(2*pi*(u+0.3)/28);"
                          "40*cos(pi*(v/15-0.5))*sin(2*pi*(u+0.3)/28); 40*sin(pi*(v/15-0.5))\nwithout doubled\n"
                          "face -60,60,33 60,60,-35 60,60,37\nface -60,60,33 60,60,37 30,80,20\n"
                          "face 60,60,37 60,60,-35 30,80,20\nface 60,60,-35 -60,60,33 30,80,20\nexact")
                          .scene();
  const DrawnOutlines drawn = draw_outlines(scene, {0, 1, 0});
  const Point2 centre = page_point(drawn.view, {0, 0, 0});
  double deepest = 0;
  for (const Point2 p : drawn.lines.points)
    deepest = std::max(deepest, kRadius * drawn.view.scale - glm::length(p - centre));
  EXPECT_LT(deepest, 0.05) << "mm on the page";
}

/// A bent curve that is seen up to its middle.
SeenContour bent_curve() {
  SeenContour contour;
  for (int i = 0; i <= 60; ++i) {
    CurvePoint point;
    point.at = i;
    point.mm = {i, 0.005 * i * i};
    if (i > 0) point.length = contour.curve.points.back().length + glm::length(point.mm - contour.curve.points.back().mm);
    contour.curve.points.push_back(point);
  }
  contour.runs = {{0, 30, 0}, {30, 60, kHiddenState}};
  return contour;
}

/// Where nothing crosses a curve, its end stays, since a curve does not hide itself where it lies on itself.
TEST(SmoothContours, ACurveDoesNotShortenItself) {
  std::vector<SeenContour> contours{bent_curve()};
  move_ends_of_contours(contours, {}, 1);
  EXPECT_EQ(contours[0].runs[0].to, 30);
  EXPECT_EQ(contours[0].runs[1].from, 30);
}

/// A line that a curve continues crosses the curve where both end. It is not hidden there.
TEST(SmoothContours, ACurveDoesNotShortenTheLineThatItContinues) {
  StrokeModel model{{{0, 0}, 1.0 / (1 << 20)}, std::vector<Stroke>(1), 1, {}};
  Stroke& line = model.strokes[0];
  line.from = model.lattice.snap({-2, -0.1});
  line.to = model.lattice.snap({5e-4, 1e-5});
  move_ends_of_strokes(model, {bent_curve()}, 1);
  EXPECT_EQ(line.t_from, 0);
}

TEST(SmoothContours, DoNotDependOnTheNumberOfThreads) {
  const Scene scene = uneven_mesh(test_surfaces()[2], 200, 100, 0.3, 7);
  Polylines one, many;
  run_with_threads(1, [&] { one = draw_outlines(scene, kIso).lines; });
  run_with_threads(8, [&] { many = draw_outlines(scene, kIso).lines; });
  expect_same(one, many);
}

TEST(SmoothContours, DoNotDependOnTheOrderOfFacesOrTheirWinding) {
  const Scene scene = uneven_mesh(test_surfaces()[1], 120, 60, 0.3, 3);
  const Polylines lines = draw_outlines(scene, kIso).lines;
  std::vector<std::uint32_t> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(11);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
  for (const bool inside_out : {false, true}) {
    Scene other = scene;
    other.faces = {};
    for (const std::uint32_t f : order) {
      const auto corners = scene.faces.contour(f, 0);
      if (inside_out) {
        other.faces.add_triangle(corners[0], corners[2], corners[1]);
      } else {
        other.faces.add_triangle(corners[1], corners[2], corners[0]);
      }
    }
    const Polylines changed = draw_outlines(other, kIso).lines;
    EXPECT_EQ(changed.size(), lines.size());
    EXPECT_NEAR(length_of(changed), length_of(lines), 0.02);
  }
}

}  // namespace
}  // namespace ligne::test
