#pragma once
/// Planes that are rows of facets of curved surfaces.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/facet_graph.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The surfaces of the faces of an object.
struct FaceSurfaces {
  std::span<const Patch> patches;
  std::vector<std::uint32_t>& patch_of;    ///< per face
  std::vector<std::uint8_t>& is_freeform;  ///< per face
};

/// Gives the faces of planes that consist of rows of facets to the surfaces beside them: if a row of facets of a torus lies
/// across its axis at the top of the tube, all of them are in one plane, and so is the row of a tube that goes on straight.
/// Each face of such a plane has an edge with a surface, lies on it with all of its corners, and is no deeper below it than
/// four times the facets of the surface. Patches on both sides of the plane that are pieces of one surface become one.
/// Rounding joins rows of two surfaces to one facet where these bend to opposite sides: its faces go to the surfaces on
/// which they lie, too, each beside a surface or beside such a face. A face of that plane that lies on none becomes free
/// form, if the others take most of the area. `surfaces` are changed. O(n).
void assign_flat_rows(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                      const FaceSurfaces& surfaces);

}  // namespace ligne
