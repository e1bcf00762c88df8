#pragma once
/// The option --cull.

#include <string>

#include "view/cull.hpp"

namespace ligne {

/// Leaves the back faces out of the projected scene, and, unless `quiet`, warns once of objects that keep them.
/// `place` stands at the head of the warning.
BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, const std::string& place,
                          bool quiet);

}  // namespace ligne
