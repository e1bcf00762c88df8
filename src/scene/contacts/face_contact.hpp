#pragma once
/// Recognises faces that cross in the mesh, but only touch in the shape.

#include <array>
#include <cstdint>

#include "scene/model/scene.hpp"

namespace ligne {

/// Precision of the coordinates of the object that a face belongs to, model units.
double object_precision(const Scene& scene, std::uint32_t face);

/// Whether two faces that cross in a segment are nowhere farther apart than `distance`, where they overlap. Beside the
/// segment the distance of their planes grows with the sine of their angle.
bool within_distance(const Scene& scene, const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment,
                     double distance);

}  // namespace ligne
