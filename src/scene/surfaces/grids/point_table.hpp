#pragma once
/// Reads points and lines in the space of a surface from tables and files of arrays (docs/data-formats.md).

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"

namespace ligne {

/// A point of a file. If z is NaN, it lies on the surface.
struct LabelledPoint {
  Point3 at{0, 0, 0};
  std::string label;
};

/// Reads points. The columns are found by their names: x, y and z, or lon, lat and height, and a label. Without such
/// names, rows are "x y", "x y z", "x y label" or "x y z label", optionally with a label first. Unused data is counted
/// in `warnings`. Throws InputError("FILE:LINE: cause").
std::vector<LabelledPoint> read_points(const std::string& file, InputFiles& opened, Warnings& warnings);

/// Reads points from the bytes of a file, whose content decides the format; `name` is used in error messages.
std::vector<LabelledPoint> read_points(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// Reads such rows as lines, which end at blank lines and at rows without a position. Drops labels.
std::vector<std::vector<Point3>> read_lines(const std::string& file, InputFiles& opened, Warnings& warnings);

}  // namespace ligne
