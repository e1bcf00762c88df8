#include "contours/convex_hull.hpp"

#include "contours/parametric_mesh.hpp"

namespace ligne::test {
namespace {

using Face = std::array<std::uint32_t, 3>;

/// Positive when p lies on the outer side of the face.
double height_over(const std::vector<Point3>& points, const Face& f, const Point3& p) {
  const Point3 a = points[f[0]];
  return glm::dot(glm::cross(points[f[1]] - a, points[f[2]] - a), p - a);
}

}  // namespace

Scene convex_hull(const std::vector<Point3>& points) {
  std::vector<Face> faces{{0, 1, 2}, {0, 2, 1}};
  for (std::uint32_t i = 3; i < points.size(); ++i) {
    // The faces that see the point give way to a cone over their rim, whose sides occur in one direction only.
    std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
    std::vector<Face> kept;
    for (const Face& f : faces) {
      if (height_over(points, f, points[i]) <= 0) {
        kept.push_back(f);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = f[k], b = f[(k + 1) % 3];
        if (rim.erase({b, a}) == 0) rim.insert({a, b});
      }
    }
    for (const auto& [a, b] : rim) kept.push_back({a, b, i});
    faces = std::move(kept);
  }
  Scene scene;
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (const Face& f : faces) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : f) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(scene.vertices.size());
        scene.vertices.push_back(points[v]);
      }
      corners.push_back(number[v]);
    }
    scene.faces.add_face(corners);
  }
  return as_one_object(std::move(scene));
}

Scene rounded_hull(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  const Point3 half{5 + 25 * unit(), 5 + 25 * unit(), 5 + 25 * unit()};
  const double radius = 4 + 11 * unit();
  std::vector<Point3> points;
  while (points.size() < std::size_t(count)) {
    const double x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
    const Point3 d{x, y, z};
    if (glm::dot(d, d) > 1 || glm::dot(d, d) < 0.01) continue;
    Point3 p = radius * glm::normalize(d);
    for (int axis = 0; axis < 3; ++axis) p[axis] += d[axis] > 0 ? half[axis] : -half[axis];
    p.x *= 1 - 0.2 * (p.z / half.z + 1);
    points.push_back(p);
  }
  return convex_hull(points);
}

}  // namespace ligne::test
