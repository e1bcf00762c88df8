#pragma once
/// All pairs of facets that may pass through each other, the hidden ones too.
///
/// Every facet lies in the cells of one of several grids, the one whose cells are as large as it is or up to twice as large:
/// in four of them at most. It is compared with the facets of its cells, and with those of the cells of coarser grids that
/// it meets: with each once, in the cell that has the first corner of what their boxes have in common. Most pairs end at
/// their boxes, or at their planes, which are apart there.

#include <vector>

#include "visibility/common/penetration.hpp"

namespace ligne {

/// O(n log n) and the pairs whose boxes, in depth too, meet in a cell.
PenetrationSearch find_crossing_facets(const ProjectedScene& scene, const std::vector<Facet>& facets);

}  // namespace ligne
