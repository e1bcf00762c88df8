#pragma once
/// Water on a surface z = f(x, y).

#include <array>
#include <cstdint>
#include <vector>

#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {

/// Triangles of a mesh that are water: 1 for each.
using WaterTriangles = std::vector<std::uint8_t>;

/// Cuts the mesh along the shore, the contour line at `level`, and lifts what is below to it: the surface of the water,
/// which has no curves. The shore is marked as a contour line.
WaterTriangles flood(SurfaceMesh& mesh, double level);

/// Samples without a height get one as far below the lowest as that is below the highest: between them and the land the
/// lowest height, which is returned, is the shore. Nothing where there are no heights.
std::optional<double> fill_holes(SurfacePoints& surface);

/// Parallel strokes over the triangles that are water, at distances of `spacing` on the ground, in coordinates times
/// `factor`; `along` is their direction there. Triangles beside each other share their strokes.
std::vector<std::array<Point3, 2>> hatch_water(const SurfaceMesh& mesh, const WaterTriangles& water, const Point3& factor,
                                               Point2 along, double spacing);

}  // namespace ligne
