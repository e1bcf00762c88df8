#pragma once
/// Points that form no grid, as a surface.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// A surface of the Delaunay triangles of points, whose heights are finite; it ends at their convex hull,
/// less the slivers along it. Points that share
/// a place stand for one of their mean height, with a warning. The result has a function (HeightSource::function()), and is
/// sampled on a grid of `columns` over the extent of the points; without `columns` of as many as the root of their number,
/// 100 to 500. Throws InputError when all points lie on a line.
std::unique_ptr<HeightSource> surface_of_points(std::vector<Point3> points, std::optional<unsigned> columns,
                                                const std::string& name, Warnings& warnings);

}  // namespace ligne
