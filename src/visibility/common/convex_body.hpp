#pragma once
/// Whether a projected scene is one convex body, as far as its front faces tell: then they are all seen, and nothing else.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne::convexity {

/// How a face stands to the viewer.
enum class Facing : std::uint8_t { edge_on, front, back };

struct Faces {
  std::vector<Facing> facing;       ///< per face of the scene; edge on too where it has no triangles
  std::vector<std::uint8_t> known;  ///< 1 when it has triangles
  double volume = 0;                ///< six times it, in lattice steps and mm of depth
  std::size_t front = 0, back = 0, edge_on = 0;
};

/// Corners of the convex hull, positively turned; those in a side are left out. Fewer than three where the points are in a
/// line. Monotone chains [Andrew1979], O(n log n), on exact signs.
std::vector<LatticePoint> convex_hull(std::vector<LatticePoint> points);

/// Twice the area of a convex contour, and its border, |dx| + |dy|.
std::array<double, 2> area_and_border(const std::vector<LatticePoint>& hull);

/// Faces by the sign of their area on the page, turned so that the front is outside: the body's volume is above zero in the
/// coordinates of the page, whose depth keeps planes plane. O(n).
Faces face_the_viewer(const ProjectedScene& scene);

/// Whether it may be worth finding out if the scene is one opaque convex body: it has edges of two faces alone, and of a
/// sample of its triangles none has vertices of the sample on both sides. O(n), for the edges.
bool looks_like_one_convex_body(const ProjectedScene& scene);

/// Why the scene is not one opaque convex body that is wholly in view; empty when it is. O(n log n).
///
/// It is when
/// - the faces of the edges are those of the triangles, and not copies that were left out,
/// - every side has two triangles, which run along it in opposite directions, and all hang together,
/// - it has a volume beyond the tolerances of touching,
/// - no two triangles of a side make an angle that is concave by more than their depth tolerances,
/// - the areas of the front triangles add up to that of the convex hull of all vertices on the page, but for a step of the
///   lattice along its border: so they lie beside each other and not over each other.
std::string why_not_one_convex_body(const ProjectedScene& scene, const Faces& faces);

}  // namespace ligne::convexity
