#pragma once
/// The order in which a painter paints faces: by one depth per face, or also by comparing pairs of faces.

#include <cstdint>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::painter {

enum class DepthSort : std::uint8_t {
  mean,      ///< the mean depth of the corners
  farthest,  ///< the depth of the farthest corner
  resolved,  ///< the farthest corner, and cases (a) and (b) of the lecture
};

struct PaintSequence {
  static constexpr std::uint32_t kNever = 0xffffffffu;

  std::vector<std::uint32_t> faces;     ///< numbers of faces, farthest first; faces seen edge on are not painted
  std::vector<std::uint32_t> place_of;  ///< per face: its place in `faces`, or kNever

  bool level = false;             ///< every face has constant depth: the sort is enough
  std::uint64_t overlapping = 0;  ///< pairs of faces that overlap on the page, and are not level there
  std::uint64_t by_depths = 0;    ///< resolved: overlapping pairs with disjoint ranges of depth
  std::uint64_t by_planes = 0;    ///< resolved: overlapping pairs in which one face lies on one side of the other's
                                  ///< plane
  std::uint64_t left = 0;         ///< resolved: overlapping pairs in neither case
  std::uint64_t in_rings = 0;     ///< resolved: faces painted before faces that should come first
  std::uint64_t penetrating = 0;  ///< pairs without a right order: each face is in front somewhere
  std::uint64_t wrong = 0;        ///< other pairs that are painted in the wrong order

  std::uint32_t place(std::uint32_t face) const { return face < place_of.size() ? place_of[face] : kNever; }
};

/// Finds the order. `grid` must list all facets, hidden ones included.
PaintSequence paint_sequence(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                             DepthSort sort);

}  // namespace ligne::painter
