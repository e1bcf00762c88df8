#pragma once
/// Details: contours of another material that lie on a face.

#include <array>
#include <cstdint>
#include <vector>

#include "drawing/result_models.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Cuts the regions of faces along their details. The parts inside a detail get its material (Region::material). Where
/// details overlap, the last one counts. Details that are partly behind the viewer are left out.
std::vector<Region> cut_details(const Scene& scene, const View& view, std::vector<Region> regions);

/// The contours of the details of faces ([Boulle1980] figure 2.62) as lines.
struct DetailLine {
  std::array<Point3, 2> ends;
  std::uint32_t face = 0;  ///< of the scene
};

/// Returns the sides of all details, in their order, clipped to their faces, so that holes are left out.
std::vector<DetailLine> detail_lines(const Scene& scene);

}  // namespace ligne
