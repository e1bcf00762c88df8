#pragma once
/// Orders a projected scene so that neighbours on the page are close in memory.

#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// Renumbers the vertices along a Morton curve over the page (Morton 1966), and sorts the triangles by their lowest vertex.
/// The work of a method on a cell or an edge then stays within the caches, which halves its time on a mesh of a million
/// triangles. Returns the new number of each vertex.
std::vector<std::uint32_t> order_faces_spatially(ProjectedScene& scene);

/// Gives the edges the new numbers of the vertices, and sorts them by their lowest vertex.
void order_edges_spatially(ProjectedScene& scene, const std::vector<std::uint32_t>& number);

/// Side in lattice steps of the squares that the curve visits: 1024 x 1024, about a million, cover the lattice.
inline constexpr std::int32_t kPageSquareSteps = 2 * kLatticeLimit >> 10;

/// The number, along the curve, of the square that contains p. Vertices are sorted by it.
std::uint32_t page_square(LatticePoint p);

}  // namespace ligne
