/// Rows of parallel edges.

#include "scene/model/edge_rows.hpp"

#include "patches/patch_scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

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

}  // namespace
}  // namespace ligne::test
