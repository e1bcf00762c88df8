#pragma once
/// Coil springs, and bodies that a plane cuts.

#include "patches/patch_scenes.hpp"

namespace ligne::test {

/// A wire of radius 2 wound about z by four turns, with a radius of 10 and a pitch of 6.
inline std::vector<Corners> spring(int facets, int sides, bool triangles) {
  const auto at = [&](int u, int v) {
    const double angle = 2 * kPi * v / facets, around = 2 * kPi * (u % sides) / sides;
    const Point3 along = glm::normalize(Point3(-10 * std::sin(angle), 10 * std::cos(angle), 3 / kPi));
    const Point3 out = on_circle(1, angle), up = glm::cross(along, out);
    return on_circle(10, angle, 6.0 * v / facets) + 2.0 * (std::cos(around) * out + std::sin(around) * up);
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 4 * facets, triangles, at);
  Corners first, last;
  for (int u = 0; u < sides; ++u) {
    first.push_back(at(u, 0));
    last.push_back(at(sides - u, 4 * facets));
  }
  polygons.push_back(first);
  polygons.push_back(last);
  return polygons;
}

/// The parts of polygons below a plane at `height` along `up`, closed by polygons in this plane.
inline std::vector<Corners> below(const std::vector<Corners>& polygons, const Point3& up, double height) {
  using Key = std::array<double, 3>;
  const auto key = [](const Point3& p) { return Key{p.x, p.y, p.z}; };
  const auto over = [&](const Point3& p) { return glm::dot(p, up) - height; };
  std::vector<Corners> kept;
  std::map<Key, Point3> next;  // along the border of the cut
  for (const Corners& polygon : polygons) {
    Corners part, ends(2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Point3 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      const bool is_up = over(a) < over(b);
      if (over(a) <= 0) part.push_back(a);
      if ((over(a) < 0) == (over(b) < 0)) continue;
      if (is_up) std::swap(a, b);  // both faces of an edge get one corner
      ends[is_up] = a + over(a) / (over(a) - over(b)) * (b - a);
      part.push_back(ends[is_up]);
    }
    if (part.size() < 3) continue;
    kept.push_back(part);
    if (ends[0] != ends[1]) next[key(ends[0])] = ends[1];
  }
  while (!next.empty()) {
    Corners cut;
    for (auto at = next.begin(); at != next.end(); at = next.find(key(cut.back()))) {
      cut.push_back(at->second);
      next.erase(at);
    }
    kept.push_back(cut);
  }
  return kept;
}

}  // namespace ligne::test
