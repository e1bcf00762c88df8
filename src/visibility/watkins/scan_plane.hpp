#pragma once
/// The scan plane as a picture ([Boulle1980] figures 2.39 to 2.50).

#include <span>

#include "drawing/result_models.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::watkins {

/// The segments of the faces on the scan line y_mm (page mm), and the steps of the span method in the options. `lines` are
/// those of make_scan_scene(). Empty if no face meets the line.
ScanPlane scan_plane(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                     double y_mm, const LineStudyOptions& options);

}  // namespace ligne::watkins
