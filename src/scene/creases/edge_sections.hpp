#pragma once
/// Cuts across edges, which tell a crease from a rounding where the triangles of a mesh have no rows.

#include <cstdint>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The angle, in radians, by which the surface turns across an edge of two faces and on both sides of it, if it bends on
/// alike there; otherwise 0. It bends on alike where in the plane across the middle of the edge, within twice the distance
/// that the bend at the edge stands for, it turns to the same side by two fifths of what a circle does that bends as at the
/// edge, and its mean bend, weighted by the bends, is that of a turn of nine facets or less. Coarse hulls bend on
/// everywhere: nothing is followed farther than `longest`, model units.
double turn_across(const Scene& scene, const Topology& topology, std::uint32_t edge, double longest);

}  // namespace ligne
