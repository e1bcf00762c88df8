#pragma once
/// Sewing borders that run along each other.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Puts vertices of the border onto other ones of the border of the same object that are nearer than the object's distance
/// (0: none), the nearest of those before them that stay. So none moves further than that. A vertex stays where it is when a
/// triangle would lose its corner or turn over. Returns the number of vertices moved, which are no longer
/// there. `settled`: per vertex that is left whether another one has come to it.
std::size_t join_border_vertices(Scene& scene, const Topology& topology, std::span<const double> distances,
                                 std::vector<std::uint8_t>& settled);

struct EdgeSplits {
  std::size_t splits = 0;
  std::size_t vertices_moved = 0;
};

/// Splits border edges where a vertex of the border of the same object lies within the object's distance of them, its foot
/// between their ends: T-junctions. The vertex moves onto the edge where that bends the faces round it less than the face of
/// the edge would bend otherwise. A triangle is cut from the corner across the edge; a polygon gets the vertex, and is cut
/// into triangles when that leaves it not planar. A face that would turn over stays as it is.
EdgeSplits split_border_edges(Scene& scene, const Topology& topology, std::span<const double> distances,
                              std::vector<std::uint8_t>& settled);

}  // namespace ligne
