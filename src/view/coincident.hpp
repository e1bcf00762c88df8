#pragma once
/// Faces and candidate edges that lie exactly on each other, such as those of a part that stands twice in a file.

#include "view/projected_scene.hpp"

namespace ligne {

/// Gives crowds of vertices that lie within the coincidence tolerance (tolerances.hpp) one place.
/// Then finds the vertices that have the same place and depth (ProjectedScene::first_at_place), and leaves out
/// - every face whose triangles are exactly those of a face of a lower number: neither hides what the other does not, and
///   where both are seen the lower one is drawn. Transparent faces stay: each dims what is behind it.
/// - every candidate edge that has its two ends in common with another one of higher precedence (the class, then the lower
///   source), to which it would lose all its strokes.
/// The drawing is that of the whole scene; its time grows with what is different in it. O(n log n), for any number of
/// coincident things. Vertices must be ordered by order_spatially().
void merge_coincident(ProjectedScene& scene);

}  // namespace ligne
