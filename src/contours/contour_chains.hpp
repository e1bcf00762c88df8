#pragma once
/// Traces the zero set of g over the triangles of a patch, as chains of segments.
///
/// g changes its sign at most once along a side, and is never zero at a vertex. So a triangle has at most one segment,
/// which joins two of its sides. A side inside a region belongs to two triangles, so the segments form closed chains,
/// or chains from border to border of the region. They never branch.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// Number of chains of contours per task of a parallel loop. Adjustable.
inline constexpr std::size_t kChainsPerTask = 8;

/// A point of the zero set on the side of a triangle.
struct ContourNode {
  std::uint32_t side = kNone;   ///< side of the patch, in the triangle of the segment that leaves it or that ends there
  Point3 on_mesh{0, 0, 0};      ///< position on the edge itself
  Point3 on_surface{0, 0, 0};   ///< position on the smooth curve that has the normals of the edge's ends
  Point3 normal{0, 0, 1};       ///< of the smooth surface, unit length
  Point3 tangent{0, 0, 0};      ///< of the contour on the surface; g grows to its right; zero if not known
  double radial = 0;            ///< if there is a tangent: its dot product with the unit vector of n x v; 0 at a cusp
  double sag = 0;               ///< bound on the distance between mesh and surface there, model units
  double sag_ahead = 0;         ///< the same for the triangle of the segment that leaves the node
  double most_mm = 0;           ///< largest permitted distance from the mesh's outline, on the page
  double bulge_mm = 0;          ///< largest permitted rise of the next segment above its chord, on the page
  std::uint32_t meets = kNone;  ///< at a border of the region: the vertex at which the mesh's outline ends
  /// The ends of its mesh edge, the one with g >= 0 first; kNone inside a triangle.
  std::array<std::uint32_t, 2> edge{kNone, kNone};
  bool is_corner = false;  ///< whether the contour turns back here, between two surfaces that join smoothly
  bool is_joint = false;   ///< whether it runs from one recognised surface, or free form, into another here

  /// Whether the contour runs along the line of sight here, inside a triangle, or turns back between two surfaces.
  bool is_cusp() const { return radial == 0 && tangent != Point3(0.0); }
};

/// The piece of a contour between two nodes: a cubic Bezier curve in space.
struct ContourCubic {
  std::array<Point3, 4> controls;
  bool with_chain;  ///< whether the tangents of the nodes point in its direction or against it

  /// Returns nothing if a tangent is not known or contradicts the chord.
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

/// Traces all contours of a patch.
std::vector<ContourChain> trace_contours(const Scene& scene, const Camera& camera, const SmoothPatch& patch);

}  // namespace ligne
