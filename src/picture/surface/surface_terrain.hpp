#pragma once
/// Features of terrain maps besides curves: water, hachures, contour lines grouped by height.

#include <vector>

#include "picture/line_groups.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "scene/surfaces/water.hpp"
#include "view/view.hpp"

namespace ligne {

/// Returns the water level of each surface, or nothing. If holes are water, their samples get heights. Throws
/// RequestError.
std::vector<std::optional<double>> water_levels(const SurfaceRequest& request, std::vector<SurfacePoints>& surfaces);

/// Returns the water level of each mesh.
std::vector<WaterTriangles> flood_all(std::vector<SurfaceMesh>& meshes, const std::vector<std::optional<double>>& levels);

/// Adds strokes that lie on the meshes: hachures and strokes of water. Call it before the meshes are cut along contour
/// lines.
void add_terrain_lines(const SurfaceRequest& request, const std::vector<SurfaceMesh>& meshes,
                       const std::vector<WaterTriangles>& water, const Point3& factor, const View& view, LineGroups& groups);

/// Groups contour lines and shorelines. `contours`: heights, ascending.
void add_contour_groups(const SurfaceRequest& request, const std::vector<double>& contours,
                        const std::vector<std::optional<double>>& water, double z_factor, LineGroups& groups);

/// The style of a contour line.
LineGroup contour_group(const CurveRequest& request, double level, std::size_t number);

}  // namespace ligne
