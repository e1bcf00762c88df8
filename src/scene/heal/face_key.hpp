#pragma once
/// A key that two faces with equal contours have in common.

#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Writes the key of a face into `key`: two faces have the same key if and only if their outer contours visit the same
/// vertices in the same cyclic order or in the reverse one, and their holes do. `name` gives the number by which a vertex
/// goes. Takes time with the number of corners, but for the order of holes.
void face_key(const Scene& scene, std::uint32_t face, FunctionRef<std::uint32_t(std::uint32_t)> name,
              std::vector<std::uint32_t>& key);

}  // namespace ligne
