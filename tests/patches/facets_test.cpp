/// Facets: rows of parallel edges, and flat sets; curves through points. Surfaces of small facets:
/// scripts/fine_surfaces.txt.

#include "patches/patch_scenes.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/patches/facets/flat_sets.hpp"
#include "scene/patches/swept/profile_curve.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

// Rows of parallel edges.

/// A strip along y of `facets` facets that bend by the given angles, in degrees, each 1 wide; of triangles where asked.
struct Strip {
  Scene scene;
  Topology topology;
  std::vector<glm::vec3> normals;

  Strip(const std::vector<double>& bends, bool triangles) {
    std::vector<Point3> profile{{0, 0, 0}, {1, 0, 0}};
    double angle = 0;
    for (const double bend : bends) {
      angle -= bend * kPi / 180;
      profile.push_back(profile.back() + Point3(std::cos(angle), 0, std::sin(angle)));
    }
    std::vector<Corners> polygons;
    add_grid(polygons, static_cast<int>(profile.size()) - 1, 1, triangles,
             [&](int u, int v) { return profile[static_cast<std::size_t>(u)] + Point3(0, 5.0 * v, 0); });
    scene = scene_of(polygons);
    topology = build_topology(scene);
    normals = face_normals(scene, topology);
  }

  EdgeRows rows() const { return {scene, topology, normals}; }

  /// The edge along y between facets k - 1 and k.
  std::uint32_t edge(int k) const {
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
      const Edge& at = topology.edges[e];
      if (at.face1 == kNone || std::abs(scene.vertices[at.v0].y - scene.vertices[at.v1].y) < 4.9) continue;
      if (scene.vertices[at.v0].x != scene.vertices[at.v1].x) continue;
      if (k-- == 1) return e;
    }
    return kNone;
  }
};

class EdgeRowsOf : public testing::TestWithParam<bool> {};

TEST_P(EdgeRowsOf, GoOnWhereEdgesBendAlike) {
  const Strip strip({20, 20, 20, 7, 20, -20}, GetParam());
  const EdgeRows rows = strip.rows();
  const auto both = rows.beside(strip.edge(2), kEvenBends);
  ASSERT_TRUE(both);
  for (const EdgeRows::Step& step : *both) {
    EXPECT_TRUE(step.edge == strip.edge(1) || step.edge == strip.edge(3));
    EXPECT_NEAR(step.distance, 1, 1e-6);
  }
  EXPECT_NE((*both)[0].edge, (*both)[1].edge);
  // An edge of 7 degrees bends by too little; at the last one the strip bends to the other side.
  EXPECT_FALSE(rows.beside(strip.edge(3), kRoundingBends));
  EXPECT_FALSE(rows.beside(strip.edge(5), kRoundingBends));
  EXPECT_TRUE(rows.beside(strip.edge(4), kRoundingBends));
  EXPECT_FALSE(rows.beside(strip.edge(4), kEvenBends));
}

TEST_P(EdgeRowsOf, EndAtCornersOfPolygonsAndBorders) {
  const Strip strip({25, 25, 50, 25}, GetParam());
  const EdgeRows rows = strip.rows();
  for (const int k : {1, 2, 3, 4}) EXPECT_FALSE(rows.beside(strip.edge(k), kRoundingBends)) << k;
}

TEST_P(EdgeRowsOf, CompareAllEdgesWithTheFirst) {
  const Strip strip({10, 18, 27, 27}, GetParam());
  const EdgeRows rows = strip.rows();
  const Edge& first = strip.topology.edges[strip.edge(3)];
  int most = 0;
  for (const std::uint32_t face : {first.face0, first.face1}) {
    EdgeRows::Step step{strip.edge(3), face};
    int count = 0;
    while ((step = rows.next(step, kRoundingBends))) ++count;
    most = std::max(most, count);
  }
  EXPECT_EQ(most, 1);  // 18 of 27 degrees are alike, 10 are not, although they are of 18
}

INSTANTIATE_TEST_SUITE_P(Triangles, EdgeRowsOf, testing::Bool());

// Limits of the search for planes where coordinates are coarse for their facets.

/// Ground of n x n squares of side 1 with heights of up to 32 steps, without order; a part of it is level.
Scene rough_ground(int n, double step, int level) {
  std::vector<Corners> polygons;
  add_grid(polygons, n, n, true, [&](int u, int v) {
    const auto mixed = static_cast<std::uint32_t>(u * 73856093) ^ static_cast<std::uint32_t>(v * 19349663);
    const bool is_level = u < level && v < level;
    return Point3(u, v, is_level ? 0 : step * (mixed * 2654435761u >> 27));
  });
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// The sets of a scene in which each pair of faces seems flat.
FlatSets sets_of(const Scene& scene) {
  const Topology topology = build_topology(scene);
  std::vector<std::uint32_t> joints, order(scene.faces.size());
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edges[e].face1 != kNone) joints.push_back(e);
  }
  std::iota(order.begin(), order.end(), 0u);
  return flat_sets(scene, scene.objects[0], topology.edges, joints, order);
}

TEST(FlatSets, GiveUpRoughGround) {
  const Scene scene = rough_ground(300, 0.1, 0);
  const FlatSets sets = sets_of(scene);
  EXPECT_GT(sets.looks, 5'400'000u) << "no search that must be ended";
  EXPECT_LT(sets.looks, 6'000'000u);
  EXPECT_FALSE(sets.has_small_faces);
  std::vector<std::uint32_t> own(scene.faces.size());
  std::iota(own.begin(), own.end(), 0u);
  EXPECT_EQ(sets.set_of, own);
}

TEST(FlatSets, FindTheLevelPartOfRoughGround) {
  const FlatSets sets = sets_of(rough_ground(200, 0.1, 60));
  std::vector<std::size_t> sizes(sets.set_of.size(), 0);
  for (const std::uint32_t set : sets.set_of) ++sizes[set];
  const std::size_t largest = *std::max_element(sizes.begin(), sizes.end());
  EXPECT_GE(largest, 2u * 59 * 59);
  EXPECT_LE(largest, 2u * 62 * 62);
}

// Curves through points.

Point2 on_ellipse(double a, double b, double angle) { return {a * std::cos(angle), b * std::sin(angle)}; }

ProfileCurve ellipse(double a, double b, int n, int sides, bool is_closed) {
  std::vector<Point2> points;
  for (int i = 0; i < sides + (is_closed ? 0 : 1); ++i) points.push_back(on_ellipse(a, b, 2 * kPi * i / n));
  return {points, is_closed, false};
}

/// Largest distance of true points of an ellipse from its curve.
double error_of(const ProfileCurve& curve, double a, double b, double turn) {
  double most = 0;
  for (double t = 0; t <= turn; t += 0.01) most = std::max(most, std::abs(curve.foot(on_ellipse(a, b, t)).distance));
  return most;
}

// The sag of the polygon is 0.34 and 0.086.
TEST(ProfileCurve, FollowsCirclesClosely) {
  for (const bool is_closed : {false, true}) {
    const ProfileCurve curve = ellipse(10, 10, 12, is_closed ? 12 : 6, is_closed);
    EXPECT_LT(error_of(curve, 10, 10, kPi), 1e-3) << is_closed;
    const ProfileCurve::Foot foot = curve.foot({9, 9});
    EXPECT_NEAR(foot.distance, 9 * std::sqrt(2.0) - 10, 1e-3);
    EXPECT_NEAR(foot.curvature, 0.1, 2e-3);
    EXPECT_LT(glm::distance(foot.normal, Point2(std::sqrt(0.5))), 2e-3);
  }
}

// The sag of the polygon is up to 0.086.
TEST(ProfileCurve, FollowsEllipsesFarWithinTheSag) {
  EXPECT_LT(error_of(ellipse(10, 5, 24, 24, true), 10, 5, 2 * kPi), 0.015);
  EXPECT_LT(error_of(ellipse(10, 5, 24, 6, false), 10, 5, kPi / 2), 0.02);
  EXPECT_LT(error_of(ellipse(10, 5, 48, 48, true), 10, 5, 2 * kPi), 0.002);
}

TEST(ProfileCurve, KeepsItsPointsAndGoesOnStraightBeyondItsEnds) {
  const ProfileCurve curve = ellipse(10, 5, 24, 6, false);
  for (const Point2& p : curve.points()) EXPECT_NEAR(curve.foot(p).distance, 0, 1e-12);
  const Point2 normal = curve.foot(curve.points()[0]).normal;
  EXPECT_NEAR(curve.foot(curve.points()[0] + 3.0 * Point2(normal.y, -normal.x)).distance, 0, 1e-9);
  EXPECT_GT(normal.x, 0.99);
}

TEST(ProfileCurve, IsSymmetricAtThePoleOfABallAndNotAtATip) {
  std::vector<Point2> ball, tip;
  for (int i = 0; i <= 6; ++i) {
    ball.emplace_back(10 * std::sin(kPi * i / 12), -10 * std::cos(kPi * i / 12));
    tip.emplace_back(i, i + 0.02 * i * i);
  }
  ball[0].x = 0;
  EXPECT_LT(glm::distance(ProfileCurve(ball, false, true).foot(ball[0]).normal, Point2(0, -1)), 1e-12);
  EXPECT_GT(std::abs(ProfileCurve(tip, false, true).foot(tip[0]).normal.x), 0.6);
}

}  // namespace
}  // namespace ligne::test
