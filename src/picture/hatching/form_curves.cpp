#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "picture/hatching/form_field.hpp"

namespace ligne {
namespace {

using Key = std::tuple<double, double, double>;

/// Adds a direction to a sum, reversed if that brings it nearer.
void add_way(Point3& sum, const Point3& way) { sum += glm::dot(sum, way) < 0 ? -way : way; }

bool has_both(const std::array<Point3, 2>& ways) { return ways[0] != Point3{0, 0, 0} && ways[1] != Point3{0, 0, 0}; }

/// The vector from the previous sample to the next one. At the rim, the sample itself takes the place of the missing
/// one.
Point3 way_past(const SurfacePoints& surface, std::size_t at, std::size_t place, std::size_t count, std::size_t step) {
  const std::size_t from = place > 0 ? at - step : at, to = place + 1 < count ? at + step : at;
  const Point3 way = surface.points[to] - surface.points[from];
  return std::isfinite(way.x + way.y + way.z) ? way : Point3{0, 0, 0};
}

}  // namespace

SurfaceCurves surface_curves(const std::vector<SurfacePoints>& surfaces, const Point3& factor) {
  SurfaceCurves curves;
  if (std::ranges::none_of(surfaces, [](const SurfacePoints& s) { return s.parametric; })) return curves;
  for (const SurfacePoints& surface : surfaces) {
    for (std::size_t at = 0; at < surface.points.size(); ++at) {
      const std::size_t column = at % surface.columns, row = at / surface.columns;
      curves.points.push_back(surface.points[at] * factor);
      curves.ways.push_back({way_past(surface, at, column, surface.columns, 1) * factor,
                             way_past(surface, at, row, surface.rows, surface.columns) * factor});
    }
  }
  return curves;
}

FormField curve_field(const FormMesh& mesh, const SurfaceCurves& curves) {
  if (curves.points.empty()) return FormField::of_ground();
  std::map<Key, std::size_t> point_at;
  for (std::size_t i = 0; i < curves.points.size(); ++i) {
    const Point3& p = curves.points[i];
    if (has_both(curves.ways[i])) point_at.emplace(Key{p.x, p.y, p.z}, i);
  }
  FormField::Directions directions(mesh.points.size());
  std::vector<char> known(mesh.points.size(), 0);
  for (std::size_t n = 0; n < directions.size(); ++n) {
    const Point3& p = mesh.points[n];
    const auto found = point_at.find({p.x, p.y, p.z});
    if (found == point_at.end()) continue;
    for (std::size_t k = 0; k < 2; ++k) directions[n][k] = unit(curves.ways[found->second][k]);
    known[n] = 1;
  }
  for (bool changed = true; changed;) {  // one ring of unknown nodes after the other, from the known nodes
    changed = false;
    FormField::Directions sums(directions.size());
    for (const FormTriangle& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
          const std::uint32_t to = triangle.node[k], from = triangle.node[other];
          if (known[to] || !known[from]) continue;
          for (std::size_t way = 0; way < 2; ++way) add_way(sums[to][way], directions[from][way]);
        }
      }
    }
    for (std::size_t n = 0; n < directions.size(); ++n) {
      if (known[n] || !has_both(sums[n])) continue;
      directions[n] = {unit(sums[n][0]), unit(sums[n][1])};
      known[n] = 1;
      changed = true;
    }
  }
  return FormField(std::move(directions));
}

}  // namespace ligne
