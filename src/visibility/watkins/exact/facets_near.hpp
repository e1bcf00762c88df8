#pragma once
/// The facets that matter to a scan for a few lines.

#include <span>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

/// The facets near any of the lines on the page, in order: all that can hide a line or lie along it.
std::vector<Facet> facets_near(std::span<const SweepLine> lines, const std::vector<Facet>& facets,
                               const std::vector<ProjectedVertex>& vertices, double margin_steps);

}  // namespace ligne::watkins
