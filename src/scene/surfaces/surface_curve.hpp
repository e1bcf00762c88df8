#pragma once
/// Curves and points in the space of a surface, and what of them lies on it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// In place of the formula of z: the height of the surface there.
inline constexpr std::string_view kOnSurface = "surface";

/// Points of three formulas in t at equal distances, both ends included; that of z may be kOnSurface, and z is NaN. A place
/// where one is not a number is NaN in all. Throws InputError.
std::vector<Point3> curve_points(const std::array<std::string, 3>& formulas, double from, double to, std::size_t count);

/// The height of the triangles of a surface z = f(x, y) over a place; nothing beside it and in holes.
std::optional<double> height_at(const SurfacePoints& surface, double x, double y);

/// The segments of a line over the ground, lifted to the triangles of a surface z = f(x, y): each inside one triangle. What
/// is beside the surface is left out.
void drape(const SurfacePoints& surface, const Point3& from, const Point3& to, std::vector<std::array<Point3, 2>>& segments);

}  // namespace ligne
