#pragma once
/// The zero set of g over the triangles of a patch, as chains of segments.
///
/// g changes its sign once along a side, or not at all, and is never zero at a vertex, so a triangle holds no segment or
/// one, from one of its sides to another. A side inside a region belongs to two triangles, so segments continue each other
/// in closed chains, or in chains from border to border of the region. They never branch.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// A point of the zero set on the side of a triangle.
struct ContourNode {
  std::uint32_t side = kNone;   ///< of the patch; seen from the segment that leaves it, or that ends there
  Point3 on_mesh{0, 0, 0};      ///< on the edge itself
  Point3 on_surface{0, 0, 0};   ///< on the smooth curve that has the normals of the edge's ends
  Point3 normal{0, 0, 1};       ///< of the smooth surface, unit length
  Point3 tangent{0, 0, 0};      ///< of the contour on the surface, g grows to its right; zero when not known
  double radial = 0;            ///< where there is a tangent: its product with normal x sight, of unit length; 0 at a cusp
  double sag = 0;               ///< how far the mesh may lie from the surface there, model units
  double sag_ahead = 0;         ///< that of the triangle of the segment that leaves the node
  double most_mm = 0;           ///< largest distance from the mesh's outline on the page (contour_support.hpp)
  double bulge_mm = 0;          ///< largest rise over its chord of the segment that leaves the node, on the page
  std::uint32_t meets = kNone;  ///< at a border of the region: the vertex of the scene through which the mesh's outline runs

  /// A node inside a triangle where the contour runs along the sight.
  bool is_cusp() const { return radial == 0 && tangent != Point3(0.0); }
};

/// The piece of a contour between two nodes, in space.
struct ContourCubic {
  std::array<Point3, 4> controls;
  bool with_chain;  ///< the tangents of the nodes point in its direction

  /// None where the tangents are not known, or contradict the chord.
  static std::optional<ContourCubic> between(const ContourNode& a, const ContourNode& b);

  Point3 point(double t) const {
    const double s = 1 - t;
    return s * s * (s * controls[0] + 3 * t * controls[1]) + t * t * (3 * s * controls[2] + t * controls[3]);
  }
  Point3 tangent(double t) const {
    const double s = 1 - t;
    return 3.0 * (s * s * (controls[1] - controls[0]) + 2 * s * t * (controls[2] - controls[1]) +
                  t * t * (controls[3] - controls[2]));
  }
};

/// Segment i runs from node i to node i + 1. A closed chain repeats its first node.
struct ContourChain {
  std::vector<ContourNode> nodes;
  std::vector<std::uint32_t> triangles;  ///< of the patch, per segment
  bool closed = false;

  std::size_t size() const { return triangles.size(); }
};

std::vector<ContourChain> trace_contours(const Scene& scene, const Camera& camera, const SmoothPatch& patch);

}  // namespace ligne
