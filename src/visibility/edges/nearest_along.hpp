#pragma once
/// The nearest facet along lines of the page, stretch by stretch, as it would be seen if no line were drawn.
///
/// The lines are few beside the facets, so the lines are filed in a grid, and each facet is held against those near it. A
/// facet that lies over all of a line hides for that line whatever is behind it.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

using LineOnPage = std::array<LatticePoint, 2>;

/// A part of a line, by fractions of its length on the page.
struct SeenStretch {
  double from = 0, to = 1;
  std::uint32_t facet = kNone;  ///< kNone: the sheet
};

/// The stretches of each line, in order and without gaps. Where facets penetrate between two ends of
/// facets, the one that is nearer in the middle stands for both. `any_facet`: it is enough that there is one, it need not be
/// the nearest.
std::vector<std::vector<SeenStretch>> nearest_along(const std::vector<ProjectedVertex>& vertices,
                                                    const std::vector<Facet>& facets, const std::vector<LineOnPage>& lines,
                                                    bool any_facet);

/// Depth of the plane of a facet at a point of the page.
double plane_depth(const Facet& facet, const std::vector<ProjectedVertex>& vertices, double x, double y);

}  // namespace ligne
