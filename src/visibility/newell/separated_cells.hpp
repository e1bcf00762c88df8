#pragma once
/// Places of objects in the order of painting, by the separating planes that a scene states.
///
/// [Boulle1980] 1.2.2.1 names such planes among the facts of a scene, and 1.1.5 the orders that follow from them. Whatever
/// lies on the far side of a plane hides nothing on the side of the viewer.

#include <cstdint>
#include <vector>

#include "visibility/order/model_pieces.hpp"

namespace ligne::newell {

/// Per face the number of its cell; of two cells the one with the lower number hides nothing of the other. Empty if the
/// scene states no planes. Requires that every object lies on one side of each plane (find_false_fact()).
std::vector<std::uint32_t> separated_cells(const Scene& scene, const Viewpoint& viewpoint);

}  // namespace ligne::newell
