#pragma once
/// A face as it lies beside one of its edges.

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// From an edge to the corner of a face that is farthest from it, at a right angle to the edge.
Point3 across_face(const Scene& scene, const Edge& edge, std::uint32_t f);

/// The radius of the arc of which the faces of an edge are chords that turn by an angle, radians. A face may be a flat side
/// beside the arc: the narrower one counts.
double radius_across(const Scene& scene, const Edge& edge, double turn);

}  // namespace ligne
