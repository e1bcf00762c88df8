#pragma once
/// Turns edges inside recognised surfaces.

#include <vector>

#include "scene/patches/refine/split_triangles.hpp"

namespace ligne {

/// Least cosine of the angle between a triangle and its surface (60 degrees): others count as folded.
inline constexpr double kLeastPartCosine = 0.5;

/// Cosine of the angle between a triangle and the surface of a patch at its middle, negative if it is turned over; 0 if the
/// triangle has no area.
double cosine_to_surface(const Point3& a, const Point3& b, const Point3& c, const Patch& patch);

/// Replaces the common edge of two triangles of one patch by the edge between their other corners where one of them is
/// folded, or would be when its longest edge gets a new vertex on the surface, and where the worse of the two triangles gets
/// better. `at`: the places of the vertices. Corners that have moved leave such triangles, and CSG leaves slivers.
void turn_slivers(std::vector<FacePart>& parts, const std::vector<Point3>& at, const Scene& scene, const Patches& patches);

}  // namespace ligne
