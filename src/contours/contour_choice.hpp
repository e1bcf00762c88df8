#pragma once
/// Which edges of the mesh's outline give way to contours, and which stay.
///
/// Between a contour and the mesh's outline lie only triangles that look one way while their labels say the other, so the
/// two come in groups that hang together, and either of them is a whole outline for its group.

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
  std::vector<ContourChain> chains;  ///< that are drawn
  std::vector<std::uint32_t> sides;  ///< that are not: indices into the sides, in ascending order
};

/// Chooses per group:
/// - no contour: a fold of the mesh, which is left out;
/// - one contour from border to border, and the mesh's outline a simple path between the same ends that is straight or has
///   one corner (a cylinder, a cone): the mesh's outline stays;
/// - a triangle of it is seen exactly edge on (a flat side in the direction of the view), and its contours, if any, end at
///   borders: the mesh's outline stays, since a line on the page is all of that triangle;
/// - the contours lie more than two widths of the pen beside the mesh on the average, or have few nodes and the sag of the
///   mesh is that large: a coarse mesh is drawn as it is;
/// - more than a quarter of the contours' length lies farther from the mesh's outline on the page than the sag of the mesh
///   there and half a pen: the mesh's outline stays, since the contours are those of another shape;
/// - else the contours, moved to within that distance where they leave it; where no outline of the mesh is near they end.
ContourChoice choose_contours(const Scene& scene, const View& view, const SmoothPatch& patch,
                              std::vector<ContourChain> chains, const std::vector<OutlineSide>& sides, double pen_width_mm);

}  // namespace ligne
