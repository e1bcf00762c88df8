#pragma once
/// Pairs of faces that overlap or penetrate each other.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// Each pair is lower face << 32 | higher face. The lists are sorted and free of duplicates.
struct FacePairs {
  std::vector<std::uint64_t> overlapping;  ///< pairs with a common part of the page
  std::vector<std::uint64_t> penetrating;  ///< pairs that pass through each other
  bool complete = true;                    ///< false if there were too many pairs to test all
};

/// A grid over the page whose lists hold all facets, the hidden ones too.
CellGrid grid_of_all(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps);

/// Finds the pairs among the facets of the scene, cell by cell of grid_of_all(). Tests a few million pairs of facets at
/// most.
FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid);

/// The faces that are in front somewhere, found at sample points.
struct FacesInFront {
  std::vector<std::uint8_t> flags;  ///< per face of the scene: 1 if it was found in front
  bool complete = true;             ///< false if there were too many facets at the sample points to test all
};

/// Tests the points of a regular grid of 512 rows over the facets, and the middle of each facet. A face is in front at a
/// point inside one of its facets if no opaque facet there is nearer by more than the depth tolerance. So a face is missed
/// only where the grid misses all of its visible part, and something hides the middles of its facets. `grid` holds the
/// hidden facets too. Tests a bounded number of facets for each of them, on the average.
FacesInFront find_faces_in_front(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                 const Rect& around);

/// Extent of a face along x and y of the page, in lattice steps, and along the view direction, in mm of depth.
struct FaceExtent {
  std::array<double, 3> low, high;
};

/// The distribution of faces along the axes of the view.
///
/// [Boulle1980] 1.2.4: each method sorts by the three directions in an order of its own, Newell by z, y, x, Watkins by y, x,
/// z. Where faces are spread along one direction more than along the others, that may guide the choice of a method.
struct FaceSpread {
  /// Per axis, x, y, z: the share of all pairs of faces whose extents have a gap between them. A sort along the axis tells
  /// these pairs apart.
  std::array<double, 3> apart{};
  /// The axis along which the fewest pairs overlap, if at most half as many overlap there as along the next axis.
  std::optional<int> privileged;
};

/// Counts the pairs exactly. Extents that touch are not apart. O(n log n).
FaceSpread spread_of(std::span<const FaceExtent> faces);

}  // namespace ligne
