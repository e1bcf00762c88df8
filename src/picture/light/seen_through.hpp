#pragma once
/// The faces seen through the visible parts of transparent faces ([Boulle1980] 2.4.2.6, figure 2.71).

#include <cstdint>
#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/lattice.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// For each region of a transparent face the numbers of the regions next behind it that have a part of the page in common
/// with it; what is seen through these stands in their own lists. Empty when no region lies behind a transparent face.
std::vector<std::vector<std::uint32_t>> seen_through(const Scene& scene, const std::vector<Region>& regions,
                                                     const Lattice& lattice);

}  // namespace ligne
