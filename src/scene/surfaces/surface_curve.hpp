#pragma once
/// Curves and points in the space of a surface, and their parts on it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// Replaces the formula of z: the height of the surface at the point.
inline constexpr std::string_view kOnSurface = "surface";

/// Points of three formulas in t at equal distances, both ends included. The formula of z may be kOnSurface; z is then
/// NaN. If one coordinate is not a number, all are NaN. Throws InputError.
std::vector<Point3> curve_points(const std::array<std::string, 3>& formulas, double from, double to, std::size_t count);

/// The height of the triangles of a surface z = f(x, y) at a place; nothing beside the surface and in holes.
std::optional<double> height_at(const SurfacePoints& surface, double x, double y);

/// Lifts a line over the ground to the triangles of a surface z = f(x, y), as segments inside one triangle each. Parts
/// beside the surface are dropped.
void drape(const SurfacePoints& surface, const Point3& from, const Point3& to, std::vector<std::array<Point3, 2>>& segments);

}  // namespace ligne
