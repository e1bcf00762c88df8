#pragma once
/// Meshes of small parts whose surfaces are known.

#include "patches/patch_scenes.hpp"

namespace ligne::test {

/// Number of facets round each bore of bored_plate().
inline constexpr int kBoreFacets = 24;

/// A plate 40 x 20 x 5 on the plane z = 0 with two bores through it along z, about (10, 10) and (30, 10).
inline std::vector<Corners> bored_plate(double left_radius, double right_radius) {
  std::vector<Corners> polygons;
  for (const bool right : {false, true}) {
    const Point3 middle(right ? 30 : 10, 10, 0);
    const double radius = right ? right_radius : left_radius;
    const auto inner = [&](int i, double z) {
      return middle + on_circle(radius, 2 * kPi * (i % kBoreFacets) / kBoreFacets, z);
    };
    const auto outer = [&](int i, double z) {
      const Point3 way = on_circle(1, 2 * kPi * (i % kBoreFacets) / kBoreFacets);
      const Point3 p = middle + way * (10 / std::max(std::abs(way.x), std::abs(way.y)));
      return Point3(std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6, z);  // both halves have the same corners
    };
    for (int i = 0; i < kBoreFacets; ++i) {
      polygons.push_back({inner(i + 1, 0), inner(i, 0), inner(i, 5), inner(i + 1, 5)});
      polygons.push_back({inner(i, 5), outer(i, 5), outer(i + 1, 5), inner(i + 1, 5)});
      polygons.push_back({inner(i + 1, 0), outer(i + 1, 0), outer(i, 0), inner(i, 0)});
      const double x = (outer(i, 0).x + outer(i + 1, 0).x) / 2;
      if (std::abs(x - 20) < 1e-6) continue;  // where both halves meet
      polygons.push_back({outer(i, 0), outer(i + 1, 0), outer(i + 1, 5), outer(i, 5)});
    }
  }
  return polygons;
}

/// A closed body of revolution about z: rings of facets between circles, each of a radius and a height, with flat ends.
/// `triangles`: the rings are of triangles.
inline std::vector<Corners> turned_body(int facets, const std::vector<Point2>& circles, bool triangles = false) {
  std::vector<Corners> polygons;
  const auto at = [&](int u, int v) {
    const Point2 circle = circles[static_cast<std::size_t>(v)];
    return on_circle(circle.x, 2 * kPi * (u % facets) / facets, circle.y);
  };
  const int rows = static_cast<int>(circles.size()) - 1;
  add_grid(polygons, facets, rows, triangles, at);
  Corners bottom, top;
  for (int u = 0; u < facets; ++u) {
    bottom.push_back(at(facets - u, 0));
    top.push_back(at(u, rows));
  }
  polygons.push_back(bottom);
  polygons.push_back(top);
  return polygons;
}

/// A ball of radius 4 about (1, 2, 3), whose poles are on a line along z.
inline std::vector<Corners> ball() {
  constexpr int kMeridians = 24, kParallels = 12;
  const auto point = [&](int u, int v) {
    const double up = kPi * v / kParallels - kPi / 2;
    const double radius = v == 0 || v == kParallels ? 0 : 4 * std::cos(up);
    return Point3(1, 2, 3) + on_circle(radius, 2 * kPi * (u % kMeridians) / kMeridians, 4 * std::sin(up));
  };
  std::vector<Corners> polygons;
  add_grid(polygons, kMeridians, kParallels, false, point);
  for (Corners& polygon : polygons) {  // triangles at the poles
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    if (polygon.front() == polygon.back()) polygon.pop_back();
  }
  return polygons;
}

/// The polygons as an OBJ.
inline std::string obj_of(const std::vector<Corners>& polygons) {
  std::ostringstream obj;
  obj.precision(9);
  for (const Corners& polygon : polygons) {
    for (const Point3& p : polygon) obj << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    obj << 'f';
    for (std::size_t i = polygon.size(); i > 0; --i) obj << " -" << i;
    obj << '\n';
  }
  return obj.str();
}

}  // namespace ligne::test
