#pragma once
/// Triangles put together into the faces that they are parts of.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne::zbuffer {

/// The ends of a side, the lower number first.
using Side = std::array<std::uint32_t, 2>;

/// Appends the sides that the triangles of a face do not share to `sides`; `all` is room to work in. O(n log n).
void append_borders(std::span<const Triangle> triangles, std::vector<Side>& all, std::vector<Side>& sides);

/// The triangles with those of each face behind each other, in the order of faces; as they are where each is a face of its
/// own. O(n).
std::vector<Triangle> by_face(std::vector<Triangle> triangles);

}  // namespace ligne::zbuffer
