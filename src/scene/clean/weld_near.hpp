#pragma once
/// Closes the seams of models whose patches were tessellated separately.

#include "scene/model/scene.hpp"

namespace ligne {

/// Merges the positions of vertices of one object that lie within `distance` (model units, positive) of each other.
/// Each vertex moves onto an earlier vertex that is near enough and has not moved itself. So no vertex moves by more
/// than `distance`, and vertices that stay apart are farther apart than that. The result depends on the order of the
/// vertices alone. Takes time proportional to the number of vertices. Vertices that are not finite stay unchanged.
/// Objects must own ascending ranges, or there must be none.
void weld_near_vertices(Scene& scene, double distance);

}  // namespace ligne
