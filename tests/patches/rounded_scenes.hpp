#pragma once
/// Meshes whose coordinates are coarse for their facets.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "patches/patch_scenes.hpp"
#include "scene/creases/find_creases.hpp"

namespace ligne::test {

/// The scene of polygons whose coordinates were rounded to whole steps.
inline Scene rounded_scene(std::vector<Corners> polygons, double step) {
  for (Corners& polygon : polygons) {
    for (Point3& p : polygon)
      p = {step * std::round(p.x / step), step * std::round(p.y / step), step * std::round(p.z / step)};
  }
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// A slanting tube, closed by two rings, of triangles. Its height is 3, its bore half as wide.
inline std::vector<Corners> tube(int sides, double radius) {
  const Point3 axis = glm::normalize(Point3(0.3, -0.2, 1)), side = glm::normalize(glm::cross(axis, Point3(1, 0, 0)));
  const Point3 other = glm::cross(axis, side);
  const auto point = [&](double r, int u, double z) {
    const double angle = 2 * kPi * (u % sides) / sides;
    return r * std::cos(angle) * side + r * std::sin(angle) * other + z * axis;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius, u, 3 * v); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (1 - 0.5 * v), u, 3); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (0.5 + 0.5 * v), u, 0); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius / 2, u, 3 - 3 * v); });
  return polygons;
}

inline std::size_t count_creases(const Scene& scene) {
  const Creases creases = find_creases(scene, build_topology(scene), {30, kSurfaceCreaseDegrees});
  return static_cast<std::size_t>(std::count(creases.lines.begin(), creases.lines.end(), kCreaseLine));
}

}  // namespace ligne::test
