#pragma once
/// Removes coincident faces and candidate edges, such as those of a part that a file contains twice.

#include "view/projected_scene.hpp"

namespace ligne {

/// First moves clusters of vertices within the coincidence tolerance (tolerances.hpp) to one position
/// (vertex_clusters.hpp). Then finds vertices with equal position and depth (ProjectedScene::first_at_place), and removes
/// every face with exactly the same triangles as a face of a lower number: both hide the same, and where both are visible
/// the lower one is drawn. Transparent faces stay, since each of them counts. Returns the replaced faces.
///
/// The drawing does not change, and the time of a method depends only on what remains. O(n log n) for any number of
/// coincident faces and edges. Vertices must be sorted by order_faces_spatially().
///
/// `may_repeat`: Topology::may_repeat_triangles of triangles that were not clipped.
ReplacedFaces merge_coincident_faces(ProjectedScene& scene, bool may_repeat);

/// Gives the candidate edges the faces that stay, and removes every one with the same two ends as another one of higher
/// precedence (by class, then the lower source), to which it would lose all its strokes.
void merge_coincident_edges(ProjectedScene& scene, const ReplacedFaces& replaced);

}  // namespace ligne
