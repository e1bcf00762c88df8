#pragma once
/// Edges with the number of faces before each of their parts, tested one by one or carried from vertex to vertex.

#include <optional>

#include "visibility/edges/propagation.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The strokes of edge_visibility(), where hidden ones have the number of faces before them as their level. Without a
/// propagation every edge is tested against all faces.
VisibilityResult counted_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                    std::optional<Propagation> propagation);

}  // namespace ligne
