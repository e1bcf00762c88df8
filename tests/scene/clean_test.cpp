/// Large and random scenes that are cleaned, merged and welded. Small ones: scripts/mended.txt.

#include "scene/clean/clean.hpp"

#include "mended_scene.hpp"
#include "scene/clean/weld.hpp"
#include "scene/model/topology.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Corners = std::vector<std::uint32_t>;
using Points = std::vector<Point3>;

Scene cleaned(Scene scene) {
  Warnings warnings;
  finish_scene(scene, warnings);
  EXPECT_TRUE(warnings.counts().empty());
  return scene;
}

void add_object(Scene& scene, const Points& points, const std::vector<Corners>& faces, double precision = 0) {
  const auto vertex = static_cast<std::uint32_t>(scene.vertices.size()),
             face = static_cast<std::uint32_t>(scene.faces.size());
  scene.vertices.insert(scene.vertices.end(), points.begin(), points.end());
  for (Corners corners : faces) {
    for (std::uint32_t& v : corners) v += vertex;
    scene.faces.add_face(corners);
  }
  scene.objects.push_back({"", vertex, static_cast<std::uint32_t>(scene.vertices.size()), face,
                           static_cast<std::uint32_t>(scene.faces.size()), precision});
}

Corners corners(const Scene& scene) {
  const auto c = scene.faces.corners();
  return {c.begin(), c.end()};
}

TEST(FinishScene, NothingToDoCopiesNothing) {
  Scene scene;
  add_object(scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const Point3* vertices = scene.vertices.data();
  const std::uint32_t* first = scene.faces.corners().data();
  Warnings warnings;
  finish_scene(scene, warnings);
  EXPECT_EQ(scene.vertices.data(), vertices);
  EXPECT_EQ(scene.faces.corners().data(), first);
}

TEST(FinishScene, PlanarWithinThePrecision) {
  // Each coordinate of a tilted square is off by the precision at most.
  constexpr double kPrecision = 1e-4;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-kPrecision, kPrecision);
  for (int i = 0; i < 200; ++i) {
    Points p{{0, 0, 0}, {40, 0, 40}, {40, 0.5, 40}, {20, 0.25, 20}, {0, 0.5, 0}};
    for (Point3& q : p) q += Point3(off(random), off(random), off(random));
    Scene scene;
    add_object(scene, p, {{0, 1, 2, 3, 4}}, kPrecision);
    EXPECT_EQ(cleaned(std::move(scene)).faces.size(), 1u);
  }
}

TEST(FinishScene, LargeWeldsAreRight) {
  // Every triangle of a grid has vertices of its own; two objects of the same positions.
  constexpr std::uint32_t kSide = 150;
  Scene scene;
  for (int object = 0; object < 2; ++object) {
    Points points;
    std::vector<Corners> faces;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        const auto n = static_cast<std::uint32_t>(points.size());
        for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
          points.emplace_back(0.1 * (x + dx), 0.1 * (y + dy), 0);
        faces.insert(faces.end(), {{n, n + 1, n + 2}, {n + 3, n + 4, n + 5}});
      }
    }
    add_object(scene, points, faces);
  }
  const Points before = scene.vertices;
  const Corners old = corners(scene);
  const Scene c = cleaned(scene);
  EXPECT_EQ(c.vertices.size(), 2 * (kSide + 1) * (kSide + 1));
  const Corners now = corners(c);
  ASSERT_EQ(now.size(), old.size());
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    ASSERT_EQ(c.vertices[now[k]], before[old[k]]);
    ASSERT_LE(now[k], next) << "vertices stay in the order of their first use";
    if (now[k] == next) ++next;
  }
}

/// Each facet bends away from the one before by less than the tolerance, all together by far more.
TEST(MergeCoplanar, GentleCurvesAreNotFlattened) {
  constexpr std::uint32_t kFacets = 400;
  Scene scene = reader_test::grid_of_cells({{"cells", {std::string(kFacets, '#')}}});
  for (Point3& p : scene.vertices) p.z = 1e-5 * p.x * p.x;
  scene.objects = {{"", 0, static_cast<std::uint32_t>(scene.vertices.size()), 0, kFacets, 1e-5}};
  Scene out = cleaned(std::move(scene));
  merge_coplanar_faces(out);
  EXPECT_GT(out.faces.size(), 20u);
  EXPECT_LT(out.faces.size(), 400u);
  // And every new contour keeps near the old surface: its chords are short where the curve is.
  for (const std::uint32_t v : corners(out))
    EXPECT_DOUBLE_EQ(out.vertices[v].z, 1e-5 * out.vertices[v].x * out.vertices[v].x);
}

/// A fan of a disc becomes one face, and no vertex of its fine border is lost, though each alone lies on the chord of its
/// neighbours within the precision.
TEST(MergeCoplanar, RoundBordersKeepTheirVertices) {
  constexpr std::uint32_t kCorners = 2000;
  Points points{{0, 0, 0}};
  std::vector<Corners> faces;
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.push_back({0, 1 + k, 1 + (k + 1) % kCorners});
  }
  Scene scene;
  add_object(scene, points, faces, 1e-5);
  Scene out = cleaned(std::move(scene));
  merge_coplanar_faces(out);
  ASSERT_EQ(out.faces.size(), 1u);
  EXPECT_EQ(out.faces.contour_count(0), 1u);
  EXPECT_EQ(corners(out).size(), kCorners);
}

Scene points(std::vector<Point3> vertices) {
  Scene scene;
  scene.vertices = std::move(vertices);
  return scene;
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
