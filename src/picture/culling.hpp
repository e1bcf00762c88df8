#pragma once
/// Culls back faces before the visibility method runs. Warns about back faces that stay.

#include "picture/run_report.hpp"
#include "view/cull.hpp"

namespace ligne {

/// Removes the back faces from the projected scene. One warning counts the objects that keep theirs.
BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, RunReport& run);

}  // namespace ligne
