#pragma once
/// Finds faces that are seen edge on: their plane contains the eye or, in parallel projection, the line of sight. They
/// are lines on the page and hide nothing.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/creases/face_normals.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// Per face: 1 if it is seen edge on within the errors below; empty if no face is.
///
/// The test is in model space, because rounding to the page would move corners out of line: near the eye it is
/// magnified a thousand times. Let p, q, r be the corners of a triangle relative to the eye. The scalar triple product
/// p . (q x r) = p . n with n = (q - p) x (r - p) is six times the volume that they span. It counts as zero up to the
/// sum of
///
///   e |n|                             the eye is as near to the plane as the precision e of the object,
///   d (|q x r| + |r x p| + |p x q|)   its change if each coordinate moves by the rounding d,
///
/// and its own rounding error; |.| is the sum of the absolute components. In parallel projection the product is that
/// of n and the line of sight, which has no position that could be near a plane, so the first term is omitted.
///
/// `largest`: the largest absolute coordinate of the scene. `sure`: sure_facings(), or empty.
std::vector<std::uint8_t> faces_seen_edge_on(const Scene& scene, const Topology& topology, const Camera& camera,
                                             double largest, std::span<const std::int8_t> sure = {});

/// The sides of triangles that their normals tell at once. Per face: 1 if it certainly faces the viewer, -1 if it certainly
/// faces away, and is not seen edge on; 0 if the normal does not tell. Most triangles of a fine mesh are sure. Empty for
/// perspective views. `shapes`: of the scene; `largest`: its largest absolute coordinate.
std::vector<std::int8_t> sure_facings(const Scene& scene, const Camera& camera, const TriangleShapes& shapes,
                                      double largest);

/// The test for one triangle with corners in model coordinates: `precision` is e, `rounding` is d.
bool is_seen_edge_on(const Point3& p, const Point3& q, const Point3& r, const Camera& camera, double precision,
                     double rounding);

/// The rounding d for a scene whose largest absolute coordinate is `largest`.
double view_rounding(const Camera& camera, double largest);

}  // namespace ligne
