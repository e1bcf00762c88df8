#pragma once
/// Finds extruded and revolved surfaces among the facets that no other surface was found for.

#include <cstdint>
#include <vector>

#include "scene/patches/facet_graph.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The facets of an object.
struct FacetObject {
  const Scene& scene;
  const Topology& topology;
  const Object& object;
  const FacetGraph& graph;
};

/// The surfaces of the facets of an object.
struct FacetPatches {
  std::vector<Patch>& patches;
  std::vector<std::uint32_t>& patch_of;    ///< per facet: index in `patches`, or kNone
  std::vector<std::uint8_t>& is_freeform;  ///< per facet, as freeform_facets() says
};

/// Makes patches of free-form facets, and of bands of them that lie on cylinders, cones, spheres and tori by accident:
/// - *extruded*: strips between parallel rulings. The direction is that of the rulings.
/// - *revolved*: facets between circles about one axis, which is that of a band, fitted to the corners of all of them: where
///   the normals meet it [PottmannRandrup1998].
/// The corners lie on the rulings and on the circles within 8 precisions of the coordinates. Each patch is one smooth piece
/// of a profile (smooth_pieces()). A patch that becomes part of another has no facets left. The search for extruded surfaces
/// ends where few of 64 facets are in such strips, as in scans. O(n log n) for the facets of the object.
void find_swept_surfaces(const FacetObject& object, const FacetPatches& surfaces);

}  // namespace ligne
