#pragma once
/// Which of two facets is in front where they overlap on the page, decided once for all of the overlap: Atherton and
/// Weiler's comparison of depths for the piece that a clip has found inside, and the order of faces that touch in a scan by
/// lines.

#include <cstdint>
#include <vector>

#include "geometry/exact_segment.hpp"
#include "visibility/common/depth_order.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

struct FacetOrder {
  DepthOrder order = DepthOrder::apart;
  bool touching = false;  ///< somewhere over the overlap they are within their tolerances of each other
  bool tie = false;       ///< everywhere: they coincide, and the face of the lower number is taken for the one in front
  LatticeSegment cut{};   ///< two lattice points of the common line
};

/// The answer depends on the two facets alone and not on their order: order_of(b, a) is order_of(a, b) with the roles
/// exchanged, and the same cut in the other direction. So of two facets each point of the page is given to exactly one.
FacetOrder order_of(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t a,
                    std::uint32_t b);

}  // namespace ligne
