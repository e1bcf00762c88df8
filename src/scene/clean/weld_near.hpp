#pragma once
/// Closing the seams of models whose patches were tessellated one by one.

#include "scene/model/scene.hpp"

namespace ligne {

/// Vertices of one object that lie within `distance` (model units, positive) of each other come to lie on one position: each
/// vertex goes to the one before it that is near enough and stands where it was stored. So no vertex moves by more than
/// `distance`, and vertices that stay apart are farther from each other than that. The order of vertices decides, nothing
/// else. Takes time with the number of vertices. Vertices that are not finite stay as they are. Objects must own ascending
/// ranges or none.
void weld_near_vertices(Scene& scene, double distance);

}  // namespace ligne
