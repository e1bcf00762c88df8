#pragma once
/// Crowds of vertices: more than can be told apart on paper.

#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// Adjustable: so many vertices in a cube are left alone.
inline constexpr std::size_t kCrowdOfVertices = 16;

/// Gives all vertices of a crowd one place and depth. A crowd is more than sixteen vertices in a cube of the given side,
/// with those in the cubes around it; the fullest cube gathers first, so no vertex moves by more than two sides along an
/// axis, and what is no crowd stays as it is. Each pair of the faces of a crowd would be just within the tolerances of each
/// other or just not: their number would grow with the square of the input, and what they draw would be noise. Vertices must
/// be ordered by order_spatially(). O(n log n).
void gather_crowds(std::vector<ProjectedVertex>& vertices, double side_steps, double side_mm);

}  // namespace ligne
