#pragma once
/// Sews borders that run along each other.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/heal/border_gaps.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// State of a sewing in progress.
struct Sewing {
  std::vector<double> distances;  ///< per object; 0: it is not sewn, or not any more
  /// Per vertex: 1 for all vertices on borders of the objects that are sewn, and possibly for others.
  std::vector<std::uint8_t> may_be_on_border{};
  std::vector<std::uint8_t> settled{};  ///< per vertex: it has moved, or another one has moved onto it
  /// All faces that have such a vertex, and possibly others, of the objects that are sewn; ascending.
  std::vector<std::uint32_t> faces{};
};

/// Moves border vertices onto earlier border vertices of the same object that stay and are nearer than the object's
/// distance, each onto the nearest. So no vertex moves further than that. A vertex stays where it is if a triangle
/// would lose its corner or turn over. Returns the number of vertices moved, which are then removed. `borders`: those
/// of the objects that are sewn.
std::size_t join_border_vertices(Scene& scene, std::span<const std::unique_ptr<Border>> borders, Sewing& sewing);

struct EdgeSplits {
  std::size_t splits = 0;
  std::size_t vertices_moved = 0;
};

/// Splits border edges at T-junctions: where a border vertex of the same object lies within the object's distance of an
/// edge, with its foot between the edge's ends. The vertex moves onto the edge if that bends the faces around it less
/// than it would otherwise bend the face of the edge. A triangle is cut from the corner across the edge. A polygon gets
/// the vertex, and is cut into triangles if it is no longer planar. A face that would turn over stays as it is.
EdgeSplits split_border_edges(Scene& scene, Sewing& sewing);

}  // namespace ligne
