#pragma once
/// Neighbours on the page become neighbours in memory.

#include "view/projected_scene.hpp"

namespace ligne {

/// Renumbers the vertices along a Morton curve over the page (Morton 1966), and orders the triangles and the edges by their
/// lowest vertex. What a method then does cell by cell or edge by edge stays within the caches; on a mesh of a million
/// triangles that halves its time.
void order_spatially(ProjectedScene& scene);

/// Side of the squares of the page that the curve runs through, a million of them.
inline constexpr std::int32_t kPageSquareSteps = 2 * kLatticeLimit >> 10;

/// The square of the page by which vertices are ordered: its number along the curve.
std::uint32_t page_square(LatticePoint p);

}  // namespace ligne
