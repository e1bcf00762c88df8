#pragma once
/// Parts with roundings, tessellated at any accuracy: shells through rings that are rounded rectangles.

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::test {

using PartTriangles = std::vector<std::array<Point3, 3>>;

inline constexpr std::string_view kRoundedParts[] = {"plate", "tray", "tube", "arch", "elbow"};

/// - plate: 40 x 30 x 14 with fillets of 3 along all edges;
/// - tray: open at the top, with tapered walls, a round rim, and fillets inside and outside;
/// - tube: round, with a shoulder that has a fillet below and a rounding above, and a bore;
/// - arch: half a turn of a bar with rounded edges;
/// - elbow: a round pipe through a quarter of a turn, with straight ends.
/// `steps`: facets to a quarter of a turn of each rounding.
PartTriangles rounded_part(std::string_view name, int steps);

/// A binary STL file. Throws std::runtime_error if it can't be written.
void write_stl(const PartTriangles& triangles, const std::filesystem::path& file);

}  // namespace ligne::test
