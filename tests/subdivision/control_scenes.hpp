#pragma once
/// Control meshes for tests, and what subdivision makes of them.

#include "scene/model/scene_parts.hpp"
#include "scene/subdivision/subdivide.hpp"
#include "support/test.hpp"

namespace ligne::subdivision_test {

using test::expect_parts;
using test::failure_of;

using Polygons = std::vector<std::vector<std::uint32_t>>;

inline Scene scene_of(const std::vector<Point3>& points, const Polygons& polygons) {
  Scene scene;
  begin_object(scene, "control");
  scene.vertices = points;
  for (const auto& polygon : polygons) scene.faces.add_face(polygon);
  scene.objects[0].vertex_end = static_cast<std::uint32_t>(points.size());
  scene.objects[0].face_end = static_cast<std::uint32_t>(polygons.size());
  return scene;
}

/// The cube of the corners +-1; vertex i has the coordinates of the bits of i.
inline std::vector<Point3> cube_points() {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return points;
}
inline const Polygons kCube{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// Every edge of the cube, as sharp as that.
inline CreaseTags creased_cube(float sharpness) {
  CreaseTags tags;
  for (const auto& face : kCube)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [a, b] = std::minmax(face[k], face[(k + 1) % 4]);
      tags.edges.push_back({a, b, sharpness});
    }
  return tags;
}

/// A grid of n x n quads over the square [0, n]^2.
inline Scene grid(std::uint32_t n) {
  std::vector<Point3> points;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) points.emplace_back(x, y, 0);
  Polygons quads;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      quads.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return scene_of(points, quads);
}

struct Made {
  Scene scene;
  SubdivisionReport report;
  Warnings warnings;
};

inline Made subdivided(Scene scene, SubdivisionScheme scheme, std::optional<unsigned> levels, const CreaseTags& tags = {}) {
  Made made{std::move(scene), {}, {}};
  made.report = subdivide(made.scene, {{scheme, levels}, {}, true}, tags, "M", made.warnings);
  return made;
}

inline Made subdivided(const std::vector<Point3>& points, const Polygons& polygons, SubdivisionScheme scheme,
                       std::optional<unsigned> levels, const CreaseTags& tags = {}) {
  return subdivided(scene_of(points, polygons), scheme, levels, tags);
}

inline void expect_near(const Point3& a, const Point3& b, double tolerance) {
  EXPECT_LE(glm::distance(a, b), tolerance)
      << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

constexpr auto kCatmullClark = SubdivisionScheme::catmull_clark;
constexpr auto kLoop = SubdivisionScheme::loop;

}  // namespace ligne::subdivision_test
