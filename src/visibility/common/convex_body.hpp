#pragma once
/// Decides whether a projected scene is one convex body. If it is, exactly its front faces are visible.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne::convexity {

/// Side of a face that the viewer sees.
enum class Facing : std::uint8_t { edge_on, front, back };

struct Faces {
  std::vector<Facing> facing;       ///< per face of the scene; edge_on if it has no triangles
  std::vector<std::uint8_t> known;  ///< 1 when it has triangles
  double volume = 0;                ///< six times the volume, in lattice steps squared times mm of depth
  std::size_t front = 0, back = 0, edge_on = 0;
};

/// Twice the area of a convex contour, and the length of its border as the sum of |dx| + |dy|.
std::array<double, 2> area_and_border(const std::vector<LatticePoint>& hull);

/// Sorts faces into front and back by the sign of their area on the page. The sign of the body's volume decides which
/// sign is the front. Depth on the page keeps planes plane, so volumes have a meaning there. O(n).
Faces face_the_viewer(const ProjectedScene& scene);

/// Quick check whether the scene may be one opaque convex body: every edge has two faces, and in a sample of its
/// triangles none has vertices of the sample on both sides. O(n), for the edges.
bool looks_like_one_convex_body(const ProjectedScene& scene);

/// Why the scene is not one opaque convex body that is wholly in view; empty when it is. O(n log n).
///
/// It is one if
/// - every face at an edge has triangles (a face left out as a copy has none),
/// - every side has two triangles, which run along it in opposite directions, and all triangles are connected,
/// - its volume exceeds the tolerances of touching,
/// - no two triangles at a side form an angle that is concave by more than their depth tolerances,
/// - the areas of the front triangles add up to the area of the convex hull of all vertices on the page, within one
///   lattice step along its border: so front triangles do not overlap.
std::string why_not_one_convex_body(const ProjectedScene& scene, const Faces& faces);

}  // namespace ligne::convexity
