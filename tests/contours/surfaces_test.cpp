// Contours of uneven meshes against those of the surfaces on which their vertices lie: five surfaces, twenty views, from
// 3600 triangles on.

#include "contours/contour_lines.hpp"
#include "contours/parametric_mesh.hpp"
#include "contours/surfaces/surface_fits.hpp"
#include "drawing/measures.hpp"
#include "main/tier.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

PageLines page_lines(const Polylines& lines) {
  PageLines result({{0, 0}, {297, 210}}, 1);
  for_segments(lines, [&](Point2 a, Point2 b) { result.add(a, b); });
  return result;
}

/// Length of the lines that is farther from the truth than `mm`, as a share of all.
double share_beyond(const Polylines& lines, const PageLines& truth, double mm) {
  double beyond = 0;
  for_segments(lines, [&](Point2 a, Point2 b) {
    if (truth.distance((a + b) * 0.5, 1) > mm) beyond += glm::distance(a, b);
  });
  return beyond / length_of(lines);
}

/// How far the ends of open lines are from the nearest other line, in ascending order: where one ends at another or at a
/// cusp shows in them.
std::vector<double> ways_from_ends(const Polylines& lines) {
  std::vector<double> ways;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (glm::length(line.front() - line.back()) < 1e-6) continue;
    for (const Point2 p : {line.front(), line.back()}) {
      double best = 1000;
      for (std::size_t k = 0; k < lines.size(); ++k)
        for (std::size_t j = 1; k != i && j < lines[k].size(); ++j)
          best = std::min(best, distance_to_segment(p, lines[k][j - 1], lines[k][j]));
      ways.push_back(best);
    }
  }
  std::sort(ways.begin(), ways.end());
  return ways;
}

constexpr std::size_t kViews = 4;
const std::array<Point3, kViews> kViewDirections{{{-1, 1, -1}, {-0.3, 1, -0.8}, {0.9, 0.5, -0.65}, {0.2, 0.4, -1}}};

/// Visible curves of each surface in each view, counted in pictures of the exact contours.
const std::array<std::array<std::size_t, kViews>, 5> kCurves{
    {{3, 3, 3, 2}, {3, 3, 3, 2}, {3, 2, 3, 2}, {3, 3, 3, 2}, {2, 2, 2, 2}}};

class Surfaces : public testing::TestWithParam<std::size_t> {};

TEST_P(Surfaces, HasTheCurvesOfTheSurfaceAtEveryRefinement) {
  const ParametricSurface surface = test_surfaces()[GetParam()];
  for (std::size_t view = 0; view < kViews; ++view) {
    if (!is_chosen(std::string("contours, ") + surface.name, view, kViews)) continue;
    std::vector<double> finest;
    for (const int size : runs_all() ? std::vector{6, 4, 2, 1} : std::vector{4, 2, 1}) {
      SCOPED_TRACE(testing::Message() << surface.name << ", view " << view << ", " << 3600 * size * size << " triangles");
      const Scene scene = uneven_mesh(surface, 60 * size, 30 * size, 0.3, static_cast<std::uint32_t>(size));
      const DrawnOutlines drawn = draw_outlines(scene, kViewDirections[view]);
      EXPECT_EQ(drawn.lines.size(), kCurves[GetParam()][view]);
      const PageLines truth = page_lines(true_contours(surface, drawn.view, 800, 400));
      EXPECT_EQ(share_beyond(drawn.lines, truth, 0.05), 0);
      const std::vector<double> ways = ways_from_ends(drawn.lines);
      if (finest.empty()) finest = ways;
      ASSERT_EQ(ways.size(), finest.size());
      // At 3600 triangles a contour of the swelling surface ends 2.4 mm before its cusp, and another one where that should
      // be.
      for (std::size_t i = 0; i < ways.size() && size > 1; ++i)
        EXPECT_NEAR(ways[i], finest[i], 0.3) << "mm from an end to a line";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Contours, Surfaces, testing::Range(std::size_t{0}, std::size_t{5}),
                         [](const auto& info) { return std::string(test_surfaces()[info.param].name); });

/// A contour, its free sides, and the page.
struct FoundSides {
  const ContourChain& chain;
  const std::vector<int>& sides;
  const View& view;

  /// The node of a number, which may lie beyond the ends of a closed chain; null beyond those of an open one.
  const ContourNode* node(std::ptrdiff_t number) const {
    const auto n = static_cast<std::ptrdiff_t>(chain.size());
    if (!chain.closed && (number < 0 || number > n)) return nullptr;
    return &chain.nodes[static_cast<std::size_t>(chain.closed ? (number + n) % n : number)];
  }
  bool changes(std::size_t i) const { return sides[i] != sides[i > 0 ? i - 1 : sides.size() - 1]; }
  bool is_cusp(std::ptrdiff_t number) const { return node(number) && node(number)->is_cusp(); }
  /// Whether the contour turns back on the page, over two segments on both sides of a node.
  bool turns_back(std::ptrdiff_t number) const {
    const ContourNode *before = node(number - 2), *at = node(number), *after = node(number + 2);
    if (!before || !at || !after) return false;
    const auto on_page = [&](const ContourNode* n) { return page_point(view, n->on_mesh); };
    return glm::dot(on_page(at) - on_page(before), on_page(after) - on_page(at)) < 0;
  }
};

TEST(FreeSides, ChangeWhereTheContourTurnsBack) {
  // Beyond a cusp the surface hides its own contour: a hook of one segment is seen where the side changes too late.
  std::size_t changes = 0;
  for (const ParametricSurface& surface : test_surfaces()) {
    for (const Point3& direction : kViewDirections) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const Scene scene = uneven_mesh(surface, 40, 20, 0.3, seed);
        const View view = view_along(scene, direction);
        const Topology topology = build_topology(scene);
        ProjectedScene projected = project(scene, topology, view, {classes("outline")});
        const std::vector<std::uint8_t> no_creases(topology.edges.size(), 0);
        const SmoothContours contours = replace_outlines(scene, topology, projected, {{30, &no_creases}});
        for (std::size_t c = 0; c < contours.chains.size(); ++c) {
          const FoundSides found{contours.chains[c], contours.sides[c], view};
          for (std::size_t i = found.chain.closed ? 0 : 1; i < found.sides.size(); ++i) {
            const auto node = static_cast<std::ptrdiff_t>(i);
            bool is_known = false, is_near = false;  // within the segments over which slopes are averaged
            for (std::ptrdiff_t k = node - 3; k <= node + 3; ++k) {
              is_known |= found.is_cusp(k);
              is_near |= found.turns_back(k);
            }
            if (!found.changes(i) || is_known || !is_near) continue;
            ++changes;
            EXPECT_TRUE(found.turns_back(node)) << surface.name << ", seed " << seed << ", node " << node;
          }
        }
      }
    }
  }
  EXPECT_GT(changes, 5u);
}

// Outlines before the empty sheet have no gaps, however rough the mesh is.

constexpr int kCellsPerMm = 4, kColumns = 297 * kCellsPerMm, kRows = 210 * kCellsPerMm;

Point2 center(int column, int row) { return {(column + 0.5) / kCellsPerMm, (row + 0.5) / kCellsPerMm}; }

/// The cells of the page that faces cover, row by row.
std::vector<char> covered_cells(const Scene& scene, const View& view) {
  std::vector<char> covered(std::size_t{kColumns} * kRows, 0);
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const auto corners = scene.faces.contour(f, 0);
    std::array<Point2, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = page_point(view, scene.vertices[corners[c]]);
    const Point2 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    for (int row = int(low.y * kCellsPerMm); row <= int(high.y * kCellsPerMm); ++row)
      for (int column = int(low.x * kCellsPerMm); column <= int(high.x * kCellsPerMm); ++column) {
        const Point2 at = center(column, row);
        int left = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const Point2 d = p[(c + 1) % 3] - p[c], e = at - p[c];
          left += d.x * e.y - d.y * e.x > 0;
        }
        if (left % 3 == 0) covered[std::size_t(row) * kColumns + std::size_t(column)] = 1;
      }
  }
  return covered;
}

/// How far the rims of what is covered are from the nearest line, at the farthest; 10 mm for all beyond.
double farthest_rim(const std::vector<char>& covered, const Polylines& lines) {
  const PageLines nearest = page_lines(lines);
  double farthest = 0;
  for (int row = 1; row + 1 < kRows; ++row)
    for (int column = 1; column + 1 < kColumns; ++column) {
      const char* cell = &covered[std::size_t(row) * kColumns + std::size_t(column)];
      if (!cell[0] || (cell[1] && cell[-1] && cell[kColumns] && cell[-kColumns])) continue;
      farthest = std::max(farthest, nearest.distance(center(column, row), 10));
    }
  return farthest;
}

/// The farthest that a rim is from a line, of a body with 2 n by n cells and vertices up to `rough` beside their place, in
/// mm on the page, nearly; a vertex alone may stand out from its line by twice as much.
double widest_gap(double rough, int n, std::uint32_t seed) {
  Scene scene = uneven_mesh(test_surfaces()[seed % 5], 2 * n, n, 0.3, seed);
  std::mt19937 random(seed);
  const auto unit = [&] { return 2 * double(random()) / double(std::mt19937::max()) - 1; };
  for (Point3& v : scene.vertices) {
    const double x = unit(), y = unit(), z = unit();
    v += rough * Point3{x, y, z};
  }
  const DrawnOutlines drawn = draw_outlines(scene, {-1, 1, -1});
  return farthest_rim(covered_cells(scene, drawn.view), drawn.lines);
}

TEST(OutlineGaps, AreNoneOnRoughBodies) {
  for (const std::uint32_t seed : {7, 12, 13, 18}) EXPECT_LT(widest_gap(0.4, 60, seed), 0.9) << "seed " << seed;
}

TEST(OutlineGaps, AreNoneBetweenAContourAndAnOutlineOfTheMesh) {
  EXPECT_LT(widest_gap(0.7, 40, 106), 0.9);
  EXPECT_LT(widest_gap(0.5, 30, 99), 0.9);
}

/// Contours stray from the long triangles of simplified parts by millimetres, and end beside them.
TEST(OutlineGaps, AreNoneOnBodiesOfLongAndShortTriangles) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Scene scene = rounded_hull(60 + 7 * int(seed), seed);
    const DrawnOutlines drawn = draw_outlines(scene, {-1, 1, -1});
    EXPECT_LT(farthest_rim(covered_cells(scene, drawn.view), drawn.lines), 1.5) << "seed " << seed;
  }
}

// Grain on the sides of scans that are seen edge on.

constexpr std::uint32_t kSide = 6;
constexpr std::uint32_t kMiddle = 2 * kSide + 2;

/// A square of triangles with one sector a vertex, all of which look away but for some.
struct Grain {
  Scene scene;
  SmoothPatch patch;
  Camera camera;

  Grain() {
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) scene.vertices.push_back({i % kSide, i / kSide, 0});
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
      for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
        const std::uint32_t a = y * kSide + x;
        add({a, a + 1, a + kSide + 1});
        add({a, a + kSide + 1, a + kSide});
      }
    patch.g.assign(scene.vertices.size(), -0.5);
    patch.across.assign(patch.sector.size(), kNone);
    for (std::uint32_t s = 0; s < patch.sector.size(); ++s) {
      for (std::uint32_t o = 0; o < patch.sector.size(); ++o)
        if (patch.sector[s] == patch.sector[next_corner(o)] && patch.sector[next_corner(s)] == patch.sector[o])
          patch.across[s] = o;
    }
  }
  void add(const std::array<std::uint32_t, 3>& v) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t.v[k] = v[k];
    t.face = static_cast<std::uint32_t>(patch.triangles.size());
    patch.triangles.push_back(t);
    patch.sector.insert(patch.sector.end(), v.begin(), v.end());
    patch.complete.insert(patch.complete.end(), 3, 1);
  }
  double level(double g, std::uint32_t vertex, const std::vector<ScanObject>& scans) {
    patch.g[vertex] = g;
    level_shallow_islands(patch, scene, camera, scans);
    return patch.g[vertex];
  }
};

const std::vector<ScanObject> kAll{{.face_begin = 0, .face_end = 1000}};

TEST(ShallowIslands, TurnLikeWhatIsRoundThem) {
  EXPECT_LT(Grain().level(0.05, kMiddle, kAll), 0);
  EXPECT_LT(Grain().level(0, kMiddle, kAll), 0);
  Grain away;
  for (double& g : away.patch.g) g = 0.5;
  EXPECT_GT(away.level(-0.05, kMiddle, kAll), 0);
}

TEST(ShallowIslands, StayWhereTheyAreDeepOrOpenOrOnNoScan) {
  EXPECT_EQ(Grain().level(0.1, kMiddle, kAll), 0.1) << "deep";
  EXPECT_EQ(Grain().level(0.05, 0, kAll), 0.05) << "at the border of the region";
  EXPECT_EQ(Grain().level(0.05, kMiddle, {{.face_begin = 900, .face_end = 1000}}), 0.05);
  EXPECT_EQ(Grain().level(0.05, kMiddle, {}), 0.05);
}

// Surfaces through the vertices round a point.

using Height = std::function<double(double x, double y)>;

/// Two rings of six and twelve points round the origin, unevenly, at heights over the plane.
std::vector<Point3> rings(double size, const Height& height) {
  std::mt19937 random(5);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()) - 0.5; };
  std::vector<Point3> points;
  for (int ring = 1; ring <= 2; ++ring)
    for (int i = 0; i < 6 * ring; ++i) {
      const double angle = (i + 0.5 * unit()) / (6 * ring) * 2 * 3.14159265358979323846;
      const double radius = size * (ring + 0.5 * unit());
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      points.push_back({x, y, height(x, y)});
    }
  return points;
}

const Point3 kUp{0, 0, 1};

TEST(SurfaceFits, KnowsPolynomialsOfDegreeThree) {
  const Height height = [](double x, double y) {
    return 0.02 * x - 0.03 * y + 0.1 * x * x + 0.05 * x * y - 0.07 * y * y + 0.01 * x * x * x - 0.02 * x * y * y;
  };
  SurfaceFit fit;
  ASSERT_TRUE(fit_surface({0, 0, 0}, kUp, rings(0.5, height), fit));
  EXPECT_LT(glm::distance(fit.normal, glm::normalize(Point3{-0.02, 0.03, 1})), 1e-12);
  // A way along the surface, and the normal at its end.
  constexpr double kStep = 1e-6;
  const Point3 end = glm::normalize(Point3{-0.02 - 0.2 * kStep, 0.03 - 0.05 * kStep, 1});
  EXPECT_LT(glm::distance(ligne::turned(fit.turn, {kStep, 0, 0.02 * kStep}), end - fit.normal), 1e-5 * kStep);
}

TEST(SurfaceFits, NormalsComeNearerWithTheThirdPowerOfTheDistance) {
  // An ellipsoid beside its top, whose curvature changes.
  const Height surface = [](double x, double y) { return 5 * std::sqrt(1 - x * x / 36 - y * y / 16); };
  constexpr double kX = 1.5, kY = 1;
  const auto error = [&](double size) {
    const double top = surface(kX, kY);
    const Height height = [&](double x, double y) { return surface(kX + x, kY + y) - top; };
    SurfaceFit fit;
    EXPECT_TRUE(fit_surface({0, 0, 0}, glm::normalize(Point3{0.2, 0.3, 1}), rings(size, height), fit));
    return glm::distance(fit.normal, glm::normalize(Point3{kX / 36, kY / 16, top / 25}));
  };
  const double at_whole = error(0.4), at_half = error(0.2);
  EXPECT_LT(at_whole, 1e-3);
  EXPECT_LT(at_half, at_whole / 6);
}

TEST(SurfaceFits, RefuseWhatIsNoSurfaceOfDegreeThree) {
  SurfaceFit fit;
  std::mt19937 random(3);
  const Height noise = [&](double, double) { return 0.1 * double(random()) / double(std::mt19937::max()); };
  EXPECT_FALSE(fit_surface({0, 0, 0.05}, kUp, rings(1, noise), fit)) << "noise";
  const Height rounding = [](double x, double) { return x < 0.5 ? 0 : -0.3 * (x - 0.5); };
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rings(1, rounding), fit)) << "a flat side with a chamfer";
  const Height ball = [](double x, double y) { return std::sqrt(9 - x * x - y * y) - 3; };
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rings(1, ball), fit)) << "coarse";
  EXPECT_TRUE(fit_surface({0, 0, 0}, kUp, rings(0.25, ball), fit)) << "fine";
  std::vector<Point3> rows;
  for (int i = -4; i <= 4; ++i)
    for (const double y : {0.0, 30.0})
      if (i != 0 || y > 0) rows.push_back({std::sin(0.1 * i), y, std::cos(0.1 * i) - 1});
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rows, fit)) << "two rows";
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, std::vector<Point3>(20, Point3{0, 0, 0}), fit)) << "one place";
}

/// The places of the second have other numbers of points, too few for a cubic, and for any surface.
TEST(SurfaceFits, OfTwoPlacesAreThoseOfEachAlone) {
  const Height saddle = [](double x, double y) { return 0.05 * x * x - 0.08 * x * y + 0.01 * x; };
  const Height ball = [](double x, double y) { return std::sqrt(100 - x * x - y * y) - 10; };
  const std::vector<Point3> many = rings(0.5, saddle);
  for (const std::size_t count : {18, 10, 5, 0}) {
    std::vector<Point3> few = rings(0.7, ball);
    few.resize(count);
    const PointsRound a{{0, 0, 0}, kUp, many}, b{{0, 0, 0}, glm::normalize(Point3{0.1, 0, 1}), few};
    const auto both = fit_two_surfaces({a, b}), turned = fit_two_surfaces({b, a});
    for (const auto& [round, fits] : {std::pair{a, std::array{both[0], turned[1]}}, {b, std::array{both[1], turned[0]}}}) {
      SurfaceFit alone;
      const bool known = fit_surface(round.at, round.normal, round.points, alone);
      for (const auto& fit : fits) {
        ASSERT_EQ(fit.has_value(), known) << count << " points";
        if (!known) continue;
        EXPECT_EQ(fit->normal, alone.normal);
        EXPECT_EQ(fit->turn, alone.turn);
      }
    }
    EXPECT_TRUE(both[0]);
    EXPECT_EQ(both[1].has_value(), count >= 10);
  }
}

}  // namespace
}  // namespace ligne::test
