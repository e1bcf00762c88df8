#pragma once
/// The distribution of faces along the axes of the view.
///
/// [Boulle1980] 1.2.4: each method sorts by the three directions in an order of its own, Newell by z, y, x, Watkins by y, x,
/// z. Where faces are spread along one direction more than along the others, that may guide the choice of a method.

#include <array>
#include <optional>
#include <span>

namespace ligne {

/// Extent of a face along x and y of the page, in lattice steps, and along the view direction, in mm of depth.
struct FaceExtent {
  std::array<double, 3> low, high;
};

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
