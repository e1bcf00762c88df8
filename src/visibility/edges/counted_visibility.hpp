#pragma once
/// Visibility of edges by counting the faces in front of each part: each edge is tested by itself, or the counts are
/// carried from vertex to vertex.

#include <optional>

#include "visibility/edges/propagation.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Gives the strokes of edge_visibility(); the level of a hidden stroke is the number of faces in front of it. Without
/// a propagation every edge is tested against all faces.
VisibilityResult counted_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                    std::optional<Propagation> propagation);

}  // namespace ligne
