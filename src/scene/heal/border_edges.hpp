#pragma once
/// The edges at which sheets end.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Marks, per vertex, the ends of all edges that have an odd number of faces: those of borders, and few others. Found
/// without a topology, by what is left of the numbers of a vertex's neighbours when those that are met twice cancel. An end
/// of more than one such edge is missed when the hashes of its neighbours cancel too: one in 2^64.
std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene);

/// The ends of odd edges in a scene none of whose edges has more than two faces.
std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene, const Topology& topology);

/// The faces that have a marked vertex, ascending.
std::vector<std::uint32_t> faces_at(const Scene& scene, const std::vector<std::uint8_t>& marked);

/// The faces of the object, out of ascending faces.
std::span<const std::uint32_t> faces_of(const Object& object, std::span<const std::uint32_t> faces);

/// The border edges of every object, in the order of the objects and of their vertices.
std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology);

/// Those of one object without a topology, of the edges both of whose ends are marked. `faces`: all of the object that have
/// a marked vertex, ascending.
std::vector<Edge> border_edges(const Scene& scene, const Object& object, const std::vector<std::uint8_t>& marked,
                               std::span<const std::uint32_t> faces);

}  // namespace ligne
