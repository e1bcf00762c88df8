#pragma once
/// Smoothly connected faces, for hatching.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/model/topology.hpp"
#include "view/brightness.hpp"

namespace ligne {

/// Groups of faces that form one surface, whose common edges are not creases. Strokes continue across these edges and
/// end at the rims of patches.
struct HatchPatches {
  std::vector<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

/// Vector along the face's normal; its length is twice the area of the face.
Point3 area_vector(const Scene& scene, std::uint32_t face);

/// Returns one light for all faces of each flat patch, weighted by their areas; none for other patches. With a near
/// light each piece of a flat face has its own light, and the rows would be uneven on what looks like one face.
std::vector<std::optional<double>> flat_light(const Scene& scene, const HatchPatches& patches, const FaceLight& light);

HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees);

}  // namespace ligne
