#include "picture/surface/surface_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/degrees.hpp"
#include "picture/errors.hpp"
#include "scene/surfaces/contours/hachures.hpp"

namespace ligne {
namespace {

// Adjustable, in widths of the pen.
constexpr double kHachurePens = 2.2, kWaterPens = 5;
/// Least sine of the angle between the view and the water. At smaller angles the strokes get no closer.
constexpr double kLeastSine = 0.1;

Point3 towards_sun(const TerrainRequest& terrain) {
  const auto [sin_azimuth, cos_azimuth] = sine_cosine_degrees(terrain.sun_azimuth);
  const auto [sin_altitude, cos_altitude] = sine_cosine_degrees(terrain.sun_altitude);
  return {sin_azimuth * cos_altitude, cos_azimuth * cos_altitude, sin_altitude};
}

void add_lines(LineGroups& groups, LineGroup group, const std::vector<std::array<Point3, 2>>& lines) {
  if (lines.empty()) return;
  const auto number = static_cast<std::uint32_t>(groups.groups.size());
  groups.groups.push_back(std::move(group));
  for (const auto& ends : lines) groups.lines.push_back({ends, number});
}

}  // namespace

std::vector<std::optional<double>> water_levels(const SurfaceRequest& request, std::vector<SurfacePoints>& surfaces) {
  std::vector<std::optional<double>> levels(surfaces.size(), request.terrain.water);
  if (!request.terrain.water_at_holes) return levels;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].function) throw RequestError("water", "nodata needs --grid: formulas have no missing heights");
    levels[i] = fill_holes(surfaces[i]);
  }
  return levels;
}

std::vector<WaterTriangles> flood_all(std::vector<SurfaceMesh>& meshes, const std::vector<std::optional<double>>& levels) {
  std::vector<WaterTriangles> water(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (levels[i]) water[i] = flood(meshes[i], *levels[i]);
  }
  return water;
}

void add_terrain_lines(const SurfaceRequest& request, const std::vector<SurfaceMesh>& meshes,
                       const std::vector<WaterTriangles>& water, const Point3& factor, const View& view,
                       LineGroups& groups) {
  const TerrainRequest& terrain = request.terrain;
  const double pen_mm = request.picture.page.pen_width_mm;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (terrain.hachures != HachureKind::none) {
      HachureOptions options{.spacing = terrain.hachure_mm.value_or(kHachurePens * pen_mm) / view.scale,
                             .sun = towards_sun(terrain)};
      add_lines(groups, {"hatch"},
                terrain.hachures == HachureKind::contour ? contour_hachures(meshes[i], water[i], factor, options)
                                                         : slope_hachures(meshes[i], water[i], factor, options));
    }
    if (terrain.water_fill == WaterFill::hatch && !water[i].empty()) {
      const Point2 right{view.camera.right.x, view.camera.right.y};
      const double length = std::hypot(right.x, right.y);
      const double spacing = kWaterPens * pen_mm / (view.scale * std::max(std::abs(view.camera.forward.z), kLeastSine));
      add_lines(groups, {"water"},
                hatch_water(meshes[i], water[i], factor, length > 0 ? right / length : Point2{1, 0}, spacing));
    }
  }
}

LineGroup contour_group(const CurveRequest& request, double level, std::size_t number) {
  return {.layer = is_index_contour(request, level, number) ? "contour-index" : "contour", .height = level};
}

void add_contour_groups(const SurfaceRequest& request, const std::vector<double>& contours,
                        const std::vector<std::optional<double>>& water, double z_factor, LineGroups& groups) {
  const auto first = static_cast<std::uint32_t>(groups.groups.size());
  for (std::size_t i = 0; i < contours.size(); ++i) groups.groups.push_back(contour_group(request.curves, contours[i], i));
  const auto shore = static_cast<std::uint32_t>(groups.groups.size());
  groups.groups.push_back({"shore"});
  std::vector<double> shores;
  for (const std::optional<double>& level : water) {
    if (level) shores.push_back(*level);
  }
  groups.group_of = [=](const SourceEdge& source, LineClass line_class) -> std::uint32_t {
    if (line_class != LineClass::contour) return 0;
    const double z = source.ends[0].z / z_factor;
    double nearest = INFINITY;
    for (const double level : shores) nearest = std::min(nearest, std::abs(level - z));
    const auto next = std::lower_bound(contours.begin(), contours.end(), z);
    std::uint32_t found = shore;
    for (const auto level : {next, next - (next != contours.begin() ? 1 : 0)}) {
      if (level == contours.end() || !(std::abs(*level - z) < nearest)) continue;
      nearest = std::abs(*level - z);
      found = first + static_cast<std::uint32_t>(level - contours.begin());
    }
    return found;
  };
}

}  // namespace ligne
