#pragma once
/// Where facets of a square of the page lie across the direction of most of their longest sides.
///
/// Long facets side by side, as those of a rod, have boxes that overlap unless the rod lies along an axis of the page, and
/// depths that overlap along it. Across it they are apart.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/cell_facet.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

class ParallelExtents {
 public:
  /// Returns false, and sets nothing, where the longest sides have no common direction. `margin`: how far beyond its corners
  /// a facet counts.
  bool set(std::span<const PlacedFacet* const> facets, const CellSquare& square, double margin);

  /// The facets [begin, end) that overlap a facet, ascending. `space` holds them.
  std::span<const std::uint32_t> overlapping(std::uint32_t facet, std::uint32_t begin, std::uint32_t end,
                                             std::vector<std::uint32_t>& space) const;

 private:
  std::vector<double> from_, to_;  ///< by facet
};

}  // namespace ligne
