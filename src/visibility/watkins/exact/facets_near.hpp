#pragma once
/// The facets that a scan for a few lines has to meet.

#include <span>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

/// Those facets, in order, that come near any of the lines on the page: all that can hide one, and those along it.
std::vector<Facet> facets_near(std::span<const SweepLine> lines, const std::vector<Facet>& facets,
                               const std::vector<ProjectedVertex>& vertices, double margin_steps);

}  // namespace ligne::watkins
