#pragma once
/// Where the vertices of a subdivided mesh lie: at the next level, and on the limit surface.

#include <vector>

#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// Points of the next level, in the order of refine().
std::vector<Point3> refined_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme);

/// The point of the limit surface to which each vertex tends. The faces are quads (Catmull and Clark) or triangles (Loop),
/// as those of every level but the first. Sharpness that is left counts as if it decayed at the next level.
std::vector<Point3> limit_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme);

}  // namespace ligne
