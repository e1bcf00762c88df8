#pragma once
/// Convex parts of facets, as the contours with which faces are clipped.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// Numbers of source segments: side k of facet f is 3 f + k; all cuts share one number.
inline constexpr std::uint32_t kCutSource = 0xffffffffu;
inline std::uint32_t side_source(std::uint32_t facet, unsigned side) { return 3 * facet + side; }

/// A facet, or its part on the left of a line, as the edges of its contour, in order. The segment of a side runs from the
/// vertex of the lower number, so that both facets at the side have equal segments.
struct ClipPart {
  std::array<ContourEdge, 4> edges;
  std::uint32_t count = 0;  ///< 0 when nothing is left

  ContourFace face() const { return {{EdgeLoop(edges.begin(), edges.begin() + count)}, true}; }
};
ClipPart whole_facet(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t facet);
ClipPart left_of(const ClipPart& triangle, const LatticeSegment& line);

}  // namespace ligne
