#pragma once
/// Facets that bend as those of a smooth surface do, though none was found for them.

#include <cstdint>
#include <vector>

#include "scene/patches/facet_graph.hpp"

namespace ligne {

/// Fewer facets that bend a little against each other are planes, unless they make a regular row.
inline constexpr std::size_t kFewestFreeform = 8;

/// A plane is so many times as deep behind an edge as the facet of a free form on its other side: the flat facets of one
/// free form have about one sag, and are less uneven. Adjustable.
inline constexpr double kPlaneDepths = 3;

/// Per facet 1 where it has no surface in `patch_of` (kNone) and
/// - is so narrow that rounding decides on its normal, which is no evidence of a plane, or
/// - is a single triangle: planes of parts are seldom as small, and many free forms have nothing else, or
/// - hangs together with kFewestFreeform or more of its kind that are no planes, neither by their corners
///   (FacetGraph::is_plane) nor by their depth (kPlaneDepths), or
/// - lies in a regular row: a neighbour and it are equally wide between edges that are parallel and bend by the same angle
/// in
///   the same sense. That is a cylinder whose facets were cut by other bodies, so that their corners lie on no circle.
std::vector<std::uint8_t> freeform_facets(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                          const std::vector<std::uint32_t>& patch_of);

}  // namespace ligne
