#pragma once
/// The order in which a painter paints faces: by one depth of each, or by that and the cases that a look at two faces
/// decides.

#include <cstdint>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::painter {

enum class DepthSort : std::uint8_t {
  mean,      ///< the mean depth of the corners
  farthest,  ///< that of the farthest corner
  resolved,  ///< the farthest corner, and cases (a) and (b) of the lecture
};

struct PaintSequence {
  static constexpr std::uint32_t kNever = 0xffffffffu;

  std::vector<std::uint32_t> faces;     ///< farthest first; faces that are seen edge on are not painted
  std::vector<std::uint32_t> place_of;  ///< by face: its place in `faces`, or kNever

  bool level = false;             ///< every face has one depth: the sort is enough
  std::uint64_t overlapping = 0;  ///< pairs of faces that overlap on the page, and are not level there
  std::uint64_t by_depths = 0;    ///< resolved: of them those whose ranges of depth are disjoint
  std::uint64_t by_planes = 0;    ///< resolved: those of which one is on one side of the other's plane
  std::uint64_t left = 0;         ///< resolved: neither
  std::uint64_t in_rings = 0;     ///< resolved: faces that were painted although others should have come before
  std::uint64_t penetrating = 0;  ///< pairs of which neither order is right: each is in front somewhere
  std::uint64_t wrong = 0;        ///< other pairs that are painted in the wrong order

  std::uint32_t place(std::uint32_t face) const { return face < place_of.size() ? place_of[face] : kNever; }
};

/// `grid` lists the facets, hidden ones too.
PaintSequence paint_sequence(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                             DepthSort sort);

}  // namespace ligne::painter
