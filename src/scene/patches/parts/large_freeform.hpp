#pragma once
/// Recognises large free forms, such as scans, by samples, without the graph of all their facets.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/patches/borders/freeform_borders.hpp"
#include "scene/patches/parts/mesh_part.hpp"

namespace ligne {

/// A free form without patches.
struct LargeFreeform {
  std::vector<std::uint8_t> is_freeform;   ///< per face of the object, as freeform_facets() says
  std::vector<std::uint32_t> plane_edges;  ///< as edges_inside_planes() says
  std::vector<FreeformBorder> borders;     ///< as freeform_borders() says
};

/// Looks at the faces near some samples, spread evenly over the edges. Nothing is returned for small objects, where surfaces
/// are found near some of the samples, and where many faces lie in planes. Sets `joints` to flat_joints() of the object.
std::optional<LargeFreeform> find_large_freeform(const TriangleObject& whole, std::vector<std::uint32_t>& joints);

}  // namespace ligne
