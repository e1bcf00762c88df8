#pragma once
/// Positions of the vertices of a subdivided mesh: at the next level, and on the limit surface.

#include <vector>

#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {

/// Points of the next level, in the order of refine().
std::vector<Point3> refined_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme);

/// The limit of each vertex. The faces must be quads (Catmull-Clark) or triangles (Loop), as on every level after the
/// first. Remaining sharpness counts as if it decayed at the next level.
std::vector<Point3> limit_points(const SubdivisionMesh& mesh, SubdivisionScheme scheme);

}  // namespace ligne
