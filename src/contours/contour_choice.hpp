#pragma once
/// Chooses which edges of the mesh's outline are replaced by contours, and which stay.
///
/// Between a contour and the outline of the mesh lie only triangles that face one way while g has the sign of the other
/// way. So the two form groups, and within a group either of them is a complete outline (docs/smooth-contours.md, phase
/// 3).

#include <cstdint>
#include <span>
#include <vector>

#include "contours/contour_chains.hpp"

namespace ligne {

/// An edge of the mesh's outline inside a region.
struct OutlineSide {
  std::uint32_t edge;  ///< of the topology
  std::uint32_t side;  ///< of the patch
};

/// The edges, in ascending order, that lie inside regions of the patch.
std::vector<OutlineSide> outline_sides(const Topology& topology, const SmoothPatch& patch,
                                       std::span<const std::uint32_t> outline_edges);

struct ContourChoice {
  std::vector<ContourChain> chains;  ///< the contours to draw
  std::vector<std::uint32_t> sides;  ///< the outline edges that they replace: indices into `sides`, ascending
};

/// Decides for each group by the first case that applies:
/// - It has no contour. It is a fold of the mesh, which is not drawn.
/// - It has one contour from border to border, and the mesh's outline is a simple path between the same ends that is
///   straight or has one corner, as on a cylinder or cone. The mesh's outline stays.
/// - One of its triangles is seen exactly edge on (a flat side along the line of sight), and its contours, if any, end
///   at borders. The mesh's outline stays, since that triangle is a line on the page.
/// - The contours lie more than two pen widths beside the mesh on average, or they have few nodes and the sag is that
///   large. The mesh is coarse and is drawn as it is, unless all contours of the group lie on one recognised surface:
///   then they are exact.
/// - The sag is more than four pen widths on average, and not all contours lie on recognised surfaces. The mesh is
///   coarse, too, since contours may lie anywhere within the sag.
/// - More than a quarter of the contours' length on the page is farther from the mesh's outline than the sag plus half
///   a pen width. The mesh's outline stays, since the contours belong to another shape.
/// - Otherwise the contours are drawn. Nodes that are too far from the outline are moved to within that distance; a
///   contour ends where no outline of the mesh is near.
ContourChoice choose_contours(const Scene& scene, const View& view, const SmoothPatch& patch,
                              std::vector<ContourChain> chains, const std::vector<OutlineSide>& sides, double pen_width_mm);

}  // namespace ligne
