#pragma once
/// From a scene as read to a scene that holds its invariants.

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Warnings of faces that are left out.
inline constexpr char kDegenerateFaces[] = "faces with fewer than three distinct vertices dropped";
inline constexpr char kFacesNotFinite[] = "faces with vertices that are not finite dropped";

/// Makes one object of a scene without objects.
void own_everything(Scene& scene);

/// Welds the vertices of each object that have equal positions, drops faces that have fewer than three distinct vertices
/// (and repeated corners, and contours that collapse), triangulates faces that are not planar within the precision of
/// their object, says which faces lose area because their contours cross, and drops vertices that are not finite together
/// with their faces. Everything dropped or mended is counted in `warnings`. Faces without area whose vertices differ are
/// kept: they hide nothing, but they join their neighbours.
void finish_scene(Scene& scene, Warnings& warnings);

/// Puts coplanar neighbouring faces of one object and material together into polygons with holes.
void merge_coplanar_faces(Scene& scene);

}  // namespace ligne
