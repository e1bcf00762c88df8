#pragma once
/// Groups triangles into their faces.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne::zbuffer {

/// The ends of a side, the lower number first.
using Side = std::array<std::uint32_t, 2>;

/// Appends the border sides of a face to `sides`: those that its triangles do not share. `all` is work space. O(n log
/// n).
void append_borders(std::span<const Triangle> triangles, std::vector<Side>& all, std::vector<Side>& sides);

/// Sorts the triangles by face; unchanged if every face has one triangle. O(n).
std::vector<Triangle> by_face(std::vector<Triangle> triangles);

}  // namespace ligne::zbuffer
