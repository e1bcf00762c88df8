#pragma once
/// Sewing borders that run along each other.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/heal/border_gaps.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Sewing in progress.
struct Sewing {
  std::vector<double> distances;  ///< per object; 0: it is not sewn, or no longer
  /// Per vertex: all vertices at borders of the objects that are sewn, and maybe others.
  std::vector<std::uint8_t> may_be_on_border{};
  std::vector<std::uint8_t> settled{};  ///< per vertex: it has moved, or another one has come to it
  /// All faces of the objects that are sewn that have such a vertex, and maybe others, ascending.
  std::vector<std::uint32_t> faces{};
};

/// Puts vertices of the border onto other ones of the border of the same object that are nearer than the object's distance,
/// the nearest of those before them that stay. So none moves further than that. A vertex stays where it is when a
/// triangle would lose its corner or turn over. Returns the number of vertices moved, which are no longer
/// there. `borders`: of the objects that are sewn.
std::size_t join_border_vertices(Scene& scene, std::span<const std::unique_ptr<Border>> borders, Sewing& sewing);

struct EdgeSplits {
  std::size_t splits = 0;
  std::size_t vertices_moved = 0;
};

/// Splits border edges where a vertex of the border of the same object lies within the object's distance of them, its foot
/// between their ends: T-junctions. The vertex moves onto the edge where that bends the faces round it less than the face of
/// the edge would bend otherwise. A triangle is cut from the corner across the edge; a polygon gets the vertex, and is cut
/// into triangles when that leaves it not planar. A face that would turn over stays as it is.
EdgeSplits split_border_edges(Scene& scene, Sewing& sewing);

}  // namespace ligne
