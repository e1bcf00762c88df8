#pragma once
/// The edges at which sheets end.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The border edges of every object, in the order of the objects and of their vertices.
std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology);

/// Those of one object without a topology, of the edges both of whose ends are marked. The corners of the object are read
/// once; the rest takes time with the number of marked vertices.
std::vector<Edge> border_edges(const Scene& scene, const Object& object, const std::vector<std::uint8_t>& marked);

}  // namespace ligne
