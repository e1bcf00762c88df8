// Blocks of points in which x, y and z all vary: scan lines of a mesh, as gnuplot draws them, or polygons.

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/surfaces/grids/grid_formats.hpp"

namespace ligne {
namespace {

/// Largest number of points in a block that can be a polygon of a solid.
constexpr std::size_t kMostCorners = 16;
/// Largest number of distinct places among the points of polygons, relative to all points: each corner of a solid
/// belongs to at least three polygons. Points of a mesh occur once, except at seams and poles.
constexpr double kPlacesOfPolygons = 0.45;
constexpr std::size_t kFewestPolygons = 4;

std::size_t block_end(const PointRows& rows, std::size_t block) {
  return block + 1 < rows.block_begins.size() ? rows.block_begins[block + 1] : rows.lines.size();
}

}  // namespace

bool are_even_blocks(const PointRows& rows) {
  if (rows.block_begins.size() < 2) return false;
  const std::size_t size = block_end(rows, 0);
  for (std::size_t block = 0; block < rows.block_begins.size(); ++block) {
    if (block_end(rows, block) - rows.block_begins[block] != size) return false;
  }
  return size >= 2;
}

bool are_polygons(const PointRows& rows) {
  const std::size_t blocks = rows.block_begins.size(), count = rows.lines.size();
  if (blocks < kFewestPolygons) return false;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t corners = block_end(rows, block) - rows.block_begins[block];
    if (corners < 3 || corners > kMostCorners) return false;
  }
  std::vector<std::array<double, 3>> places;
  for (std::size_t row = 0; row < count; ++row)
    places.push_back({rows.values[3 * row], rows.values[3 * row + 1], rows.values[3 * row + 2]});
  if (std::ranges::any_of(places, [](const auto& p) { return !std::isfinite(p[0] + p[1] + p[2]); })) return false;
  std::ranges::sort(places);
  const auto different = std::unique(places.begin(), places.end()) - places.begin();
  return static_cast<double>(different) <= kPlacesOfPolygons * static_cast<double>(count);
}

SurfacePoints mesh_of_blocks(const PointRows& rows, const std::string& name) {
  SurfacePoints mesh;
  mesh.rows = rows.block_begins.size();
  mesh.columns = rows.lines.size() / mesh.rows;
  mesh.parametric = true;
  mesh.points.reserve(rows.lines.size());
  constexpr double kHole = kNoHeight;
  std::size_t holes = 0;
  for (std::size_t row = 0; row < rows.lines.size(); ++row) {
    const Point3 p{rows.values[3 * row], rows.values[3 * row + 1], rows.values[3 * row + 2]};
    const bool is_point = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    mesh.points.push_back(is_point ? p : Point3{kHole, kHole, kHole});
    holes += !is_point;
  }
  if (holes == mesh.points.size()) throw InputError(name, "contains only NODATA values");
  return mesh;
}

}  // namespace ligne
