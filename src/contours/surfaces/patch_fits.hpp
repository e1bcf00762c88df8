#pragma once
/// Surfaces through the vertices of a patch, for its normals.

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// Fits surfaces at the sectors beside the zero set of g, through the vertices of two rings of its region, and takes over
/// their normals, turns and g. A sector keeps the mean of the normals of its faces where there is no such surface, and where
/// its faces all look one way and the fitted normal the other: the zero set of g stays on triangles that touch the outline
/// of the mesh.
void fit_surfaces(const Scene& scene, const Camera& camera, SmoothPatch& patch);

}  // namespace ligne
