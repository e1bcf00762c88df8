#pragma once
/// Leaves out what is surely hidden before a scan.

#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/watkins/exact/occluder_grid.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

/// Removes facets behind covers from the list, and marks lines behind covers.
void leave_out_hidden(const ProjectedScene& scene, const OccluderGrid& covers, std::vector<Facet>& facets,
                      std::vector<SweepLine>& lines);

/// Uses cells that several connected facets cover together. A facet that no cell lists lies behind such patches everywhere,
/// or coincides with another facet there.
void leave_out_hidden(const CellGrid& grid, std::vector<Facet>& facets, std::vector<SweepLine>& lines);

/// True if the line lies behind the covers of all cells that it crosses.
bool lies_behind(const CellGrid& grid, const SweepLine& line);

}  // namespace ligne::watkins
