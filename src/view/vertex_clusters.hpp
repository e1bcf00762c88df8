#pragma once
/// Merges clusters of vertices: more vertices within the tolerance than a drawing can resolve.

#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// Largest number of vertices in a cube that are not merged. Adjustable.
inline constexpr std::size_t kMaxVerticesPerCube = 16;

/// Gives all vertices of a cluster the same position and depth. A cluster is more than kMaxVerticesPerCube vertices in
/// a cube of the given side, together with those in the cubes around it; its side is `side_steps` on the page and
/// `side_mm` in depth. The fullest cube is processed first, so no vertex moves by more than two sides along an axis.
/// Other vertices do not move. Without this, every pair of faces of a cluster would be a decision at the limit of the
/// tolerance: the work would grow with the square of the input, and the lines would be noise. Vertices must be sorted
/// by order_faces_spatially(). O(n log n).
void merge_vertex_clusters(std::vector<ProjectedVertex>& vertices, double side_steps, double side_mm);

}  // namespace ligne
