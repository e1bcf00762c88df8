#include "scene/clean/weld_near.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/topology.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

Scene points(std::vector<Point3> vertices) {
  Scene scene;
  scene.vertices = std::move(vertices);
  return scene;
}

TEST(WeldNear, TheFirstVertexStaysAndTheOthersGoThere) {
  Scene scene = points({{0, 0, 0}, {1, 0, 0}, {1.05, 0, 0}, {0.95, 0.02, 0}, {-0.05, 0, 0}});
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(WeldNear, ChainsDoNotCollapse) {
  Scene scene = points({{0, 0, 0}, {0.08, 0, 0}, {0.16, 0, 0}, {0.24, 0, 0}});
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {0, 0, 0}, {0.16, 0, 0}, {0.16, 0, 0}}));
}

TEST(WeldNear, ObjectsAreApart) {
  Scene scene = points({{0, 0, 0}, {0.01, 0, 0}, {0.02, 0, 0}});
  Object a, b;
  a.vertex_end = b.vertex_begin = 1;
  b.vertex_end = 3;
  scene.objects = {a, b};
  weld_near_vertices(scene, 0.1);
  EXPECT_EQ(scene.vertices, (std::vector<Point3>{{0, 0, 0}, {0.01, 0, 0}, {0.01, 0, 0}}));
}

TEST(WeldNear, AnyNumbersAreTaken) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const std::vector<Point3> odd{{kInf, 0, 0}, {1e60, -1e60, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {1, 2, 3}};
  for (const double distance : {std::numeric_limits<double>::denorm_min(), 1e-300, 1.0, 1e300}) {
    Scene scene = points(odd);
    weld_near_vertices(scene, distance);
    EXPECT_EQ(scene.vertices[0], odd[0]);
    EXPECT_TRUE(scene.vertices[2].x != scene.vertices[2].x);
    EXPECT_EQ(scene.vertices[3], distance < 1e300 ? odd[3] : odd[1]);
  }
}

/// Against all pairs: who moves, moves to a vertex that stayed and is near; who stays has no such vertex before it.
TEST(WeldNear, IsWhatAllPairsSay) {
  std::mt19937_64 random(7);
  for (const double distance : {0.01, 0.1, 0.4}) {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Point3> stored(600);
    for (Point3& p : stored) p = {coordinate(random), coordinate(random), coordinate(random)};
    Scene scene = points(stored);
    weld_near_vertices(scene, distance);
    std::vector<Point3> stayed;
    for (std::size_t i = 0; i < stored.size(); ++i) {
      bool near_one = false, is_there = false;
      for (const Point3& p : stayed) {
        near_one |= glm::distance(p, stored[i]) <= distance;
        is_there |= p == scene.vertices[i] && glm::distance(p, stored[i]) <= distance;
      }
      EXPECT_EQ(near_one, is_there) << i;
      if (!near_one) {
        EXPECT_EQ(scene.vertices[i], stored[i]);
        stayed.push_back(stored[i]);
      }
    }
  }
}

/// Two triangles of a square whose seam gapes by a thousandth.
TEST(WeldNear, ASeamIsNoBorder) {
  const auto borders = [](double distance) {
    Scene scene = points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.001, 0, 0}, {1, 1.001, 0}, {0, 1, 0}});
    scene.faces.add_triangle(0, 1, 2);
    scene.faces.add_triangle(3, 4, 5);
    if (distance > 0) weld_near_vertices(scene, distance);
    Warnings warnings;
    finish_scene(scene, warnings);
    std::size_t n = 0;
    for (const Edge& edge : build_topology(scene).edges) n += edge.face1 == kNone;
    return n;
  };
  EXPECT_EQ(borders(0), 6u);
  EXPECT_EQ(borders(0.0005), 6u);
  EXPECT_EQ(borders(0.002), 4u);
}

}  // namespace
}  // namespace ligne
