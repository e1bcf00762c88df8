#pragma once
/// A key that is equal for faces with equal contours.

#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Writes the key of a face into `key`. Two faces have the same key if and only if their outer contours visit the same
/// vertices in the same cyclic order or in reverse, and their holes do too. `name` maps a vertex to the number used in
/// the key. Takes time proportional to the number of corners, plus the sorting of holes.
void face_key(const Scene& scene, std::uint32_t face, FunctionRef<std::uint32_t(std::uint32_t)> name,
              std::vector<std::uint32_t>& key);

}  // namespace ligne
