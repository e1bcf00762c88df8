#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::test {

/// A binary STL file. Throws std::runtime_error if it can't be written.
void write_stl(const std::vector<std::array<Point3, 3>>& triangles, const std::filesystem::path& file);

}  // namespace ligne::test
