#pragma once
/// Details: contours of another material that lie on a face.

#include <vector>

#include "drawing/result_models.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Cuts the regions of faces along their details. The parts inside a detail get its material (Region::material). Where
/// details overlap, the last one counts. Details that are partly behind the viewer are left out.
std::vector<Region> cut_details(const Scene& scene, const View& view, std::vector<Region> regions);

}  // namespace ligne
