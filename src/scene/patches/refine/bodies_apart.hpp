#pragma once
/// Whether bodies can be refined without regard to each other.

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Whether the bodies of a scene, faces connected by edges, lie apart: no two of their bounding boxes meet, and there are
/// few. Surfaces of two bodies that touch, such as a pin in its bore, would penetrate each other if each got vertices of
/// its own.
bool bodies_lie_apart(const Scene& scene, const Topology& topology);

}  // namespace ligne
