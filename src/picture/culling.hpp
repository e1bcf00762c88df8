#pragma once
/// Back faces left out before the study.

#include "picture/run_report.hpp"
#include "view/cull.hpp"

namespace ligne {

/// Leaves the back faces out of the projected scene; objects that keep theirs add one warning.
BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, RunReport& run);

}  // namespace ligne
