#pragma once
/// Makes a surface of points that form no grid.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// A surface of the Delaunay triangles of points with finite heights. It ends at their convex hull, less the slivers
/// along it. Points at one place are replaced by one of their mean height, with a warning. The result has a function
/// (HeightSource::function()), sampled on a grid over the extent of the points with `columns` columns; by default the
/// square root of the number of points, clamped to 100 to 500. Throws InputError if all points lie on a line.
std::unique_ptr<HeightSource> surface_of_points(std::vector<Point3> points, std::optional<unsigned> columns,
                                                const std::string& name, Warnings& warnings);

}  // namespace ligne
