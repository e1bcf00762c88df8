#pragma once
/// Water on a surface z = f(x, y).

#include <array>
#include <cstdint>
#include <vector>

#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {

/// Per triangle of a mesh: 1 if it is water.
using WaterTriangles = std::vector<std::uint8_t>;

/// Cuts the mesh along the shore, the contour line at `level`, and lifts everything below to the level. This water
/// surface has no curves. The shore is marked as a contour line.
WaterTriangles flood(SurfaceMesh& mesh, double level);

/// Gives samples without a height one as far below the lowest as the highest is above it. The shore between them and
/// the land is at the lowest height, which is returned; nothing if there are no heights.
std::optional<double> fill_holes(SurfacePoints& surface);

/// Parallel strokes over the water triangles, `spacing` apart on the ground, in coordinates times `factor`; `along` is
/// their direction there. Neighbouring triangles share their strokes.
std::vector<std::array<Point3, 2>> hatch_water(const SurfaceMesh& mesh, const WaterTriangles& water, const Point3& factor,
                                               Point2 along, double spacing);

}  // namespace ligne
