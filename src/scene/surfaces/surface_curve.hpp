#pragma once
/// Curves and points in the space of a surface, and what of them lies on it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// In place of the formula of z, and where a row of points has no z: the height of the surface there.
inline constexpr std::string_view kOnSurface = "surface";

/// A point of a file. NaN for z: on the surface.
struct LabelledPoint {
  Point3 at{0, 0, 0};
  std::string label;
};

/// Points of three formulas in t at equal distances, both ends included; that of z may be kOnSurface, and z is NaN. A place
/// where one is not a number is NaN in all. Throws InputError.
std::vector<Point3> curve_points(const std::array<std::string, 3>& formulas, double from, double to, std::size_t count);

/// Rows "x y", "x y z", "x y label" or "x y z label", divided by blanks, tabs, commas or semicolons; lines that begin with #
/// and a first line without numbers are left out. Throws InputError("FILE:LINE: cause").
std::vector<LabelledPoint> read_points(const std::string& file, InputFiles& opened);

/// The height of the triangles of a surface z = f(x, y) over a place; nothing beside it and in holes.
std::optional<double> height_at(const SurfacePoints& surface, double x, double y);

/// The segments of a line over the ground, lifted to the triangles of a surface z = f(x, y): each inside one triangle. What
/// is beside the surface is left out.
void drape(const SurfacePoints& surface, const Point3& from, const Point3& to, std::vector<std::array<Point3, 2>>& segments);

}  // namespace ligne
