#pragma once
/// Normals of a patch from surfaces fitted to its vertices.

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// Fits a surface at each sector beside the zero set of g, to the vertices of two rings within its region, and stores
/// its normal, the derivative of the normal, and g. A sector keeps its mean of face normals if the fit fails, or if all
/// its faces face one way and the fitted normal the other way. So the zero set of g stays on triangles that touch the
/// outline of the mesh.
void fit_surfaces(const Scene& scene, const Camera& camera, SmoothPatch& patch);

}  // namespace ligne
