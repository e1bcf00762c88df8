#pragma once
/// Faces that hang together smoothly, for hatching.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/model/topology.hpp"
#include "view/brightness.hpp"

namespace ligne {

/// Faces that are one surface: their common edges are no creases. Strokes continue over them, and end at the rims of
/// patches.
struct HatchPatches {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

/// Twice the area of the face, along its normal.
Point3 area_vector(const Scene& scene, std::uint32_t face);

/// One light for all faces of a patch that is flat, by their areas; nothing for other patches. From near by, each piece of a
/// flat face gets light of its own, and rows would be uneven on what is seen as one face.
std::vector<std::optional<double>> flat_light(const Scene& scene, const HatchPatches& patches, const FaceLight& light);

HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees);

}  // namespace ligne
