#pragma once
/// Details: contours of another material that lie on a face.

#include <vector>

#include "drawing/result_models.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Cuts the regions of faces that have details along these: what lies in a detail gets its material (Region::material). Of
/// details that overlap the last one counts. Details of which a part is not in front of the viewer are left out.
std::vector<Region> cut_details(const Scene& scene, const View& view, std::vector<Region> regions);

}  // namespace ligne
