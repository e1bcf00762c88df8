#pragma once
/// Decides which of two facets is in front where they overlap on the page, once for the whole overlap. Atherton and
/// Weiler's method needs it for the piece inside a clip, and scan-line methods for faces that touch.

#include <cstdint>
#include <vector>

#include "geometry/exact_segment.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

struct FacetOrder {
  DepthOrder order = DepthOrder::apart;
  bool touching = false;  ///< somewhere over the overlap they are within the sum of their tolerances
  bool tie = false;       ///< they coincide all over the overlap, and the face of the lower number counts as in front
  LatticeSegment cut{};   ///< two lattice points on the common line
};

/// The result does not depend on the order of the arguments: order_of(b, a) is order_of(a, b) with the roles exchanged
/// and the cut reversed. So each point of the overlap belongs to exactly one of the two facets.
FacetOrder order_of(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t a,
                    std::uint32_t b);

}  // namespace ligne
