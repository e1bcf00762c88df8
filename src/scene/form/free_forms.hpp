#pragma once
/// Objects that are free forms, and how finely they are meshed.

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// An object that is a free form to three quarters of its area, with its edges in the topology.
struct FreeForm {
  std::uint32_t edge_begin = 0, edge_end = 0;
  double facet_part = 0;  ///< mean length of its edges, as a part of the diagonal of its box
};

/// Finds the free forms of a scene, ascending. `is_freeform`: per face, whether it lies on no recognised surface and in no
/// plane. The mean length is that of every n-th edge, of about 4,096. Objects for whose edges takes_part() returns false are
/// left out.
std::vector<FreeForm> find_free_forms(const Scene& scene, const Topology& topology,
                                      std::span<const std::uint8_t> is_freeform, FunctionRef<bool(EdgeRange)> takes_part);

}  // namespace ligne
