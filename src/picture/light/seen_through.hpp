#pragma once
/// The faces seen through the visible parts of transparent faces ([Boulle1980] 2.4.2.6, figure 2.71).

#include <cstdint>
#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/lattice.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Returns for each region of a transparent face the numbers of the regions directly behind it that overlap it on the
/// page. Regions behind these are in their own lists. Empty if no region lies behind a transparent face.
std::vector<std::vector<std::uint32_t>> seen_through(const Scene& scene, const std::vector<Region>& regions,
                                                     const Lattice& lattice);

}  // namespace ligne
