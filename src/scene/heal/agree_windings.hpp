#pragma once
/// Makes windings agree: decides which side of a sheet is the front.

#include <cstddef>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Reverses faces so that neighbours traverse their common edge in opposite directions. Works on each set of faces
/// connected by edges of two faces; of the two solutions it takes the one that reverses fewer faces. A one-sided set (a
/// Moebius strip) stays as it is. Returns the number of faces reversed. `topology` is that of the scene before. O(n);
/// if all windings agree, only the edges are read.
std::size_t agree_windings(Scene& scene, const Topology& topology);

}  // namespace ligne
