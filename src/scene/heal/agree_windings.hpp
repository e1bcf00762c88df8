#pragma once
/// Windings that agree: which side of a sheet is the front.

#include <cstddef>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Turns faces round so that neighbours run through their common edge in opposite directions, wherever a set of faces that
/// hang together over edges of two faces allows it: of the two ways, the one that turns fewer faces. A set that has only
/// one side (a Moebius strip) stays as it is. Returns the number of faces turned; `topology` is that of the scene before.
/// O(n); where all windings agree only the edges are read.
std::size_t agree_windings(Scene& scene, const Topology& topology);

}  // namespace ligne
