#pragma once
/// Edges between a free form and a plane or a recognised surface, with the evidence whether the two join smoothly or
/// meet at an angle.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/facet_graph.hpp"

namespace ligne {

struct FacetSurfaces;
struct PatchOutline;

/// One edge at which a free form ends. The normal of the free form there is extrapolated from the facets behind the
/// edge.
struct FreeformBorder {
  std::uint32_t edge = 0;   ///< of the topology
  std::uint32_t chain = 0;  ///< number of its chain: consecutive edges between one free form and one facet or surface
  double length = 0;        ///< of the edge, model units
  /// Angle between the normals of both sides, in radians; 0 if the normal of the other side lies between the
  /// extrapolated one and the normal of the first facet, as where a fillet begins with continuous curvature.
  double angle = 0;
  /// Angle by which the normal of the free form turns across its first facet, radians: how uncertain `angle` is.
  double turn = 0;
  bool is_beside_band = false;  ///< the other side is a patch that may be part of the free form (see is_band())
  bool is_fleck = false;        ///< a short chain at an isolated free-form facet that joins some neighbour smoothly
  /// The other side is a surface whose curvature across the edge clearly differs from that of the free form.
  bool bends_otherwise = false;
  bool is_beside_plane = false;  ///< the other side is a plane much wider than the first facet
};

/// The borders of the free forms of an object, sorted by edge; chains are numbered from 0. `outlines`: of the patches.
/// O(n log n).
std::vector<FreeformBorder> freeform_borders(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                             const FacetSurfaces& surfaces, std::span<const PatchOutline> outlines);

}  // namespace ligne
