#pragma once
/// Neighbours on the page become neighbours in memory.

#include "view/projected_scene.hpp"

namespace ligne {

/// Renumbers the vertices along a Morton curve over the page (Morton 1966), and orders the triangles and the edges by their
/// lowest vertex. What a method then does cell by cell or edge by edge stays within the caches; on a mesh of a million
/// triangles that halves its time.
void order_spatially(ProjectedScene& scene);

}  // namespace ligne
