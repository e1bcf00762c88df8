// Limit positions against values worked out by hand from the masks of the papers, and what holds for any control mesh.

#include "base/parallel.hpp"
#include "control_scenes.hpp"

namespace ligne::subdivision_test {
namespace {

/// Rounding of a few levels of sums.
constexpr double kRounding = 1e-13;

// The vertices of the control mesh come first, then those of its edges in the order of their ends, then those of its faces.
TEST(LimitSurface, CubeByCatmullAndClark) {
  for (unsigned levels = 1; levels <= 4; ++levels) {
    const Made made = subdivided(cube_points(), kCube, kCatmullClark, levels);
    for (std::size_t v = 0; v < 8; ++v) expect_near(made.scene.vertices[v], cube_points()[v] / 2.0, kRounding);
    EXPECT_EQ(made.scene.faces.size(), 6u * 2u << 2 * levels);
    EXPECT_EQ(made.report.triangles, made.scene.faces.size());
    EXPECT_EQ(made.report.levels, levels);
    EXPECT_EQ(made.report.faces, 6u);
  }
  const Made made = subdivided(cube_points(), kCube, kCatmullClark, 1);
  ASSERT_EQ(made.scene.vertices.size(), 8u + 12u + 6u);
  expect_near(made.scene.vertices[8], Point3(0, -1, -1) * (395.0 / 648), kRounding);  // edge 0 1
  expect_near(made.scene.vertices[20], Point3(0, 0, -1) * (68.0 / 81), kRounding);    // face 0 2 3 1
}

TEST(LimitSurface, OctahedronAndTetrahedronByLoop) {
  const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Polygons eight{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const std::vector<Point3> tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const Polygons four{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  for (unsigned levels = 1; levels <= 4; ++levels) {
    const Made of_eight = subdivided(octahedron, eight, kLoop, levels);
    for (std::size_t v = 0; v < 6; ++v) expect_near(of_eight.scene.vertices[v], octahedron[v] * (24.0 / 55), kRounding);
    EXPECT_EQ(of_eight.scene.faces.size(), 8u << 2 * levels);
    const Made of_four = subdivided(tetrahedron, four, kLoop, levels);
    for (std::size_t v = 0; v < 4; ++v) expect_near(of_four.scene.vertices[v], tetrahedron[v] / 5.0, kRounding);
  }
}

/// Polygons of several sizes with a border: a cube without its top, with a roof of triangles and a pentagon as a side.
Scene house() {
  std::vector<Point3> points = cube_points();
  points.emplace_back(0, 0, 2.5);
  points.emplace_back(0.25, -1, 1.75);
  return scene_of(points, {{0, 2, 3, 1}, {0, 1, 5, 9, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}});
}

Scene triangle_house() {
  const Scene polygons = house();
  Polygons triangles;
  for (std::size_t f = 0; f < polygons.faces.size(); ++f) {
    const auto face = polygons.faces.contour(f, 0);
    for (std::size_t k = 2; k < face.size(); ++k) triangles.push_back({face[0], face[k - 1], face[k]});
  }
  return scene_of(polygons.vertices, triangles);
}

CreaseTags house_tags() {
  CreaseTags tags;
  tags.edges = {{0, 2, 1.5f}, {2, 3, 1.5f}, {6, 7, kAlwaysSharp}, {6, 8, 0.5f}};
  tags.corners = {{3, 0.75f}};
  return tags;
}

TEST(LimitSurface, MovesWithItsControlMesh) {
  const Basis turn = rotation(0.4, 1.1, -2.3);
  const auto moved = [&](const Point3& p) {
    return turn[0] * p.x * 3.0 + turn[1] * p.y + turn[2] * p.z + Point3(5, -8, 13);
  };
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    // Loop's scheme cuts polygons along their shorter diagonals, which stretching changes.
    const auto control = [&] { return scheme == kLoop ? triangle_house() : house(); };
    const Made made = subdivided(control(), scheme, 3, house_tags());
    Scene there = control();
    for (Point3& p : there.vertices) p = moved(p);
    const Made made_there = subdivided(std::move(there), scheme, 3, house_tags());
    ASSERT_EQ(made.scene.vertices.size(), made_there.scene.vertices.size());
    for (std::size_t v = 0; v < made.scene.vertices.size(); ++v)
      expect_near(made_there.scene.vertices[v], moved(made.scene.vertices[v]), 100 * kRounding);
  }
}

// All levels have their vertices on one surface. The creases here end in corners and borders: where one ends in a smooth
// surface its end is taken as smooth, which comes near the limit with the levels.
TEST(LimitSurface, IsTheSameFromEveryLevel) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    CreaseTags tags;
    tags.edges = {{0, 1, kAlwaysSharp}, {0, 2, kAlwaysSharp}, {2, 3, kAlwaysSharp}};
    const Made coarse = subdivided(house(), scheme, 2, tags), fine = subdivided(house(), scheme, 4, tags);
    // The vertices of a level come first in the next one.
    for (std::size_t v = 0; v < coarse.scene.vertices.size(); ++v)
      expect_near(coarse.scene.vertices[v], fine.scene.vertices[v], 10 * kRounding);
  }
}

TEST(LimitSurface, OfAFlatGridIsThatGrid) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    const Made made = subdivided(grid(3), scheme, 3);
    double area = 0;
    for (std::size_t f = 0; f < made.scene.faces.size(); ++f) {
      const auto t = std::as_const(made.scene.faces).contour(f, 0);
      const Point3 &a = made.scene.vertices[t[0]], &b = made.scene.vertices[t[1]], &c = made.scene.vertices[t[2]];
      const Point3 twice = glm::cross(b - a, c - a);
      EXPECT_GT(twice.z, 0);
      area += twice.z / 2;
    }
    EXPECT_NEAR(area, 9, 1e-12);
    std::size_t corners = 0;
    for (const Point3& p : made.scene.vertices) {
      EXPECT_EQ(p.z, 0);
      EXPECT_TRUE(p.x >= 0 && p.x <= 3 && p.y >= 0 && p.y <= 3);
      corners += (p.x == 0 || p.x == 3) && (p.y == 0 || p.y == 3);
    }
    EXPECT_EQ(corners, 4u);
  }
}

// A border is the cubic B-spline of its vertices, whatever the mesh beside it.
TEST(LimitSurface, BorderIsASpline) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    Scene scene = grid(3);
    scene.vertices[1].y = -2, scene.vertices[2].z = 5, scene.vertices[5].z = 7;
    const std::vector<Point3> control = scene.vertices;
    const Made made = subdivided(std::move(scene), scheme, 3);
    expect_near(made.scene.vertices[1], (control[0] + control[1] * 4.0 + control[2]) / 6.0, kRounding);
    expect_near(made.scene.vertices[2], (control[1] + control[2] * 4.0 + control[3]) / 6.0, kRounding);
    expect_near(made.scene.vertices[0], control[0], 0);
  }
}

TEST(LimitSurface, SharesItsVertices) {
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    const Made made = subdivided(cube_points(), kCube, scheme, 3);
    // Euler's formula of a closed surface of triangles without handles: F = 2 V - 4.
    EXPECT_EQ(made.scene.faces.size(), 2 * made.scene.vertices.size() - 4);
    EXPECT_TRUE(made.warnings.lines().empty());
  }
}

TEST(LimitSurface, DoesNotDependOnThreads) {
  std::vector<Made> made;
  for (const unsigned threads : {1u, 2u, 7u})
    run_with_threads(threads, [&] { made.push_back(subdivided(house(), kCatmullClark, 6, house_tags())); });
  for (const Made& other : made) {
    EXPECT_EQ(made[0].scene.vertices, other.scene.vertices);
    EXPECT_TRUE(
        std::ranges::equal(std::as_const(made[0].scene.faces).corners(), std::as_const(other.scene.faces).corners()));
    EXPECT_EQ(made[0].scene.corner_flags, other.scene.corner_flags);
  }
}

TEST(LimitSurface, DoesNotDependOnTheOrderOfFaces) {
  std::mt19937 random(5);
  for (const SubdivisionScheme scheme : {kCatmullClark, kLoop}) {
    const Scene control = house();
    Polygons polygons;
    for (std::size_t f = 0; f < control.faces.size(); ++f) {
      const auto contour = control.faces.contour(f, 0);
      polygons.emplace_back(contour.begin(), contour.end());
    }
    const auto sorted = [](std::vector<Point3> points) {
      // Rounding may differ by the order of sums; the last bits would decide on the order here.
      for (Point3& p : points) p = Point3(std::round(p.x * 1e9), std::round(p.y * 1e9), std::round(p.z * 1e9)) + 0.0;
      std::ranges::sort(points, {}, [](const Point3& p) { return std::tuple(p.x, p.y, p.z); });
      return points;
    };
    const Made made = subdivided(house(), scheme, 3, house_tags());
    for (int i = 0; i < 5; ++i) {
      std::ranges::shuffle(polygons, random);
      for (auto& polygon : polygons) std::ranges::rotate(polygon, polygon.begin() + 1);
      const Made other = subdivided(control.vertices, polygons, scheme, 3, house_tags());
      EXPECT_TRUE(sorted(made.scene.vertices) == sorted(other.scene.vertices));
    }
  }
}

TEST(SubdivisionLevels, FollowTheSizeOfEdges) {
  // The edges of a cube are 0.577 of its size.
  EXPECT_EQ(subdivided(cube_points(), kCube, kCatmullClark, {}).report.levels, 6u);
  // 200 x 200 quads have edges of 0.0035, which one level halves.
  EXPECT_EQ(subdivided(grid(200), kCatmullClark, {}).report.levels, 1u);
}

TEST(SubdivisionLevels, StopAtAMillionTrianglesByThemselves) {
  // A crumpled sheet: its edges are a quarter of its size.
  Scene scene = grid(90);
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) scene.vertices[v].z = v % 2 ? 40 : 0;
  const Made made = subdivided(std::move(scene), kCatmullClark, {});
  EXPECT_EQ(made.report.levels, 2u);
  EXPECT_EQ(made.report.triangles, 90u * 90u * 2u * 16u);
}

TEST(SubdivisionLevels, AreRefusedWhereTheyMakeTooMany) {
  const std::string failure = failure_of([] { subdivided(grid(50), kCatmullClark, 8); });
  expect_parts(failure, {"M: 8 levels of subdivision would make 327680000 triangles of it, more than 16777216: 5 would do"});
  EXPECT_EQ(subdivided(grid(5), kLoop, 5).report.triangles, 50u << 10);
}

}  // namespace
}  // namespace ligne::subdivision_test
