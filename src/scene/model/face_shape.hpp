#pragma once
/// The shape of a face in its plane.

#include <cstdint>

#include "scene/model/scene.hpp"

namespace ligne {

/// Whether a face has no hole and turns to one side at all its corners. Straight corners do not count, nor do turns within
/// `tolerance`, a length in model units. O(corners).
bool is_convex_face(const Scene& scene, std::uint32_t face, double tolerance);

}  // namespace ligne
