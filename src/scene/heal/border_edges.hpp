#pragma once
/// Finds the edges at which sheets end.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Marks, per vertex, the ends of all edges with an odd number of faces: mostly border edges. Works without a topology:
/// hashes of a vertex's neighbours are combined by exclusive or, so that neighbours met twice cancel. An end of several
/// such edges is missed if the hashes of its neighbours cancel too: one case in 2^64.
std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene);

/// Marks the ends of odd edges in a scene without edges of more than two faces.
std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene, const Topology& topology);

/// The faces that have a marked vertex, ascending.
std::vector<std::uint32_t> faces_at(const Scene& scene, const std::vector<std::uint8_t>& marked);

/// The faces of the object among ascending faces.
std::span<const std::uint32_t> faces_of(const Object& object, std::span<const std::uint32_t> faces);

/// The border edges of every object, in the order of the objects and of their vertices.
std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology);

/// Finds the border edges of one object without a topology, among the edges whose two ends are marked. `faces`: all
/// faces of the object that have a marked vertex, ascending.
std::vector<Edge> border_edges(const Scene& scene, const Object& object, const std::vector<std::uint8_t>& marked,
                               std::span<const std::uint32_t> faces);

}  // namespace ligne
