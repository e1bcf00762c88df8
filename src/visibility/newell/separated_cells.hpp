#pragma once
/// Places of objects in the painting order, by the separating planes that a scene states.
///
/// [Boulle1980] 1.2.2.1 lists such planes among the facts of a scene, and 1.1.5 the orders that follow from them. Objects on
/// the far side of a plane hide nothing on the viewer's side.

#include <cstdint>
#include <vector>

#include "visibility/order/model_pieces.hpp"

namespace ligne::newell {

/// Cell number per face; faces of a lower cell hide nothing in a higher one. Empty if the scene states no planes. Requires
/// that every object lies on one side of each plane (find_false_fact()).
std::vector<std::uint32_t> separated_cells(const Scene& scene, const Viewpoint& viewpoint);

}  // namespace ligne::newell
