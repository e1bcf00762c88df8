#pragma once
/// The zero set of g over the triangles of a patch, as chains of segments.
///
/// g is linear over a triangle and never zero at a vertex, so a triangle holds no segment or one, from one of its sides to
/// another. A side inside a region belongs to two triangles, so segments continue each other in closed chains, or in chains
/// from border to border of the region. They never branch.

#include <cstdint>
#include <vector>

#include "contours/smooth_patch.hpp"

namespace ligne {

/// A point of the zero set on the side of a triangle.
struct ContourNode {
  std::uint32_t side = kNone;   ///< of the patch; seen from the segment that leaves it, or that ends there
  Point3 on_mesh{0, 0, 0};      ///< on the edge itself
  Point3 on_surface{0, 0, 0};   ///< on the smooth curve that has the normals of the edge's ends
  Point3 normal{0, 0, 1};       ///< of the smooth surface, unit length
  std::uint32_t meets = kNone;  ///< at a border of the region: the vertex of the scene through which the mesh's outline runs
};

/// Segment i runs from node i to node i + 1. A closed chain repeats its first node.
struct ContourChain {
  std::vector<ContourNode> nodes;
  std::vector<std::uint32_t> triangles;  ///< of the patch, per segment
  bool closed = false;

  std::size_t size() const { return triangles.size(); }
};

std::vector<ContourChain> trace_contours(const Scene& scene, const SmoothPatch& patch);

}  // namespace ligne
