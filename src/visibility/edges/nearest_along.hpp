#pragma once
/// The nearest facet along lines of the page, stretch by stretch.
///
/// There are far fewer lines than facets, so the grid holds the lines, and each facet is tested against the lines near
/// it. A facet that covers a whole line hides everything behind it from that line.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

using LineOnPage = std::array<LatticePoint, 2>;

/// A part of a line, in fractions of its length on the page.
struct SeenStretch {
  double from = 0, to = 1;
  std::uint32_t facet = kNone;  ///< kNone: the sheet
};

/// Returns the stretches of each line, in order and without gaps. Where two facets penetrate within a stretch, the one
/// that is nearer at its middle is given for all of it. `any_facet`: any facet will do, not only the nearest.
std::vector<std::vector<SeenStretch>> nearest_along(const std::vector<ProjectedVertex>& vertices,
                                                    const std::vector<Facet>& facets, const std::vector<LineOnPage>& lines,
                                                    bool any_facet);

/// Depth of the plane of a facet at a point of the page.
double plane_depth(const Facet& facet, const std::vector<ProjectedVertex>& vertices, double x, double y);

}  // namespace ligne
