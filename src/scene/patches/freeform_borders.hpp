#pragma once
/// Edges between a free form and a plane or a surface that was found: does the free form run into it, or meet it at an
/// angle?

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/facet_graph.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

struct FacetSurfaces;
struct PatchOutline;

/// One edge at which a free form ends. Its normal there is continued from the facets behind the edge.
struct FreeformBorder {
  std::uint32_t edge = 0;   ///< of the topology
  std::uint32_t chain = 0;  ///< edges of one chain follow each other between one free form and one other facet or surface
  double length = 0;
  /// Angle in radians between both normals; 0 where that of the other side lies between the continued one and that of the
  /// first facet, as it does where a fillet begins without a step of its curvature.
  double angle = 0;
  double turn = 0;              ///< radians by which the free form turns over its first facet, which makes `angle` uncertain
  bool is_beside_band = false;  ///< the other side is a patch that may be a part of the free form (PatchOutline::is_band)
  bool is_fleck = false;        ///< a short chain at a facet without free-form neighbours that runs on smoothly somewhere
  bool is_beside_plane = false;  ///< the other side is a plane much wider than the first facet
};

/// The borders of the free forms of an object, in ascending order of edges; chains are counted from 0. `outlines`: of the
/// patches. O(n log n).
std::vector<FreeformBorder> freeform_borders(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                             const FacetSurfaces& surfaces, std::span<const PatchOutline> outlines);

}  // namespace ligne
