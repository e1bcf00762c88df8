#pragma once
/// Faces whose plane contains the eye, or the line of sight in parallel projection: they are seen as a line and hide
/// nothing.

#include <cstdint>
#include <vector>

#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// Per face 1 when it is seen edge on, as far as that is certain; empty when no face is.
///
/// Decided in model space, before anything is rounded to the page: there the corners of such a face, near the eye magnified
/// a thousand times, are no longer in a line. With the corners p, q, r of a triangle relative to the eye the mixed product
/// p . (q x r) = p . n, n = (q - p) x (r - p), is six times the volume that they span. It counts as zero up to the sum of
///   e |n|                             the eye is so near to the plane as the precision e of the object,
///   d (|q x r| + |r x p| + |p x q|)   what it changes by when the rounding d moves each coordinate,
/// and its own roundings; |.| is the sum of the absolute components. In parallel projection the mixed product is that of n
/// and the line of sight, which has no place that could be near to a plane: there the first term is left out.
std::vector<std::uint8_t> faces_seen_edge_on(const Scene& scene, const Topology& topology, const Camera& camera);

/// is_seen_edge_on() for one triangle: `precision` is e, `rounding` d.
bool is_seen_edge_on(const Point3& p, const Point3& q, const Point3& r, const Camera& camera, double precision,
                     double rounding);

/// The rounding of sights of a scene with coordinates up to that size.
double sight_rounding(const Camera& camera, double largest);

}  // namespace ligne
