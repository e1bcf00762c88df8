#pragma once
/// Cleans a scene after reading, so that the invariants of Scene hold.

#include <optional>

#include "scene/clean/weld.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Texts of the warnings about removed faces.
inline constexpr char kDegenerateFaces[] = "faces with fewer than three distinct vertices dropped";
inline constexpr char kFacesNotFinite[] = "faces with vertices that are not finite dropped";

/// If a scene has no objects, adds one that owns all vertices and faces.
void make_single_object(Scene& scene);

/// Makes the invariants of Scene hold, and counts every removal and repair in `warnings`:
/// - removes vertices that are not finite, with their faces;
/// - welds the vertices of each object that have equal positions;
/// - removes repeated corners, collapsed contours, and faces with fewer than three distinct vertices;
/// - triangulates faces that are not planar within the precision of their object;
/// - warns of faces that lose area because their contours cross.
///
/// Faces without area but with distinct vertices stay: they hide nothing, but they connect their neighbours.
/// `known`: weld_vertices() of the scene if it is known.
void finish_scene(Scene& scene, Warnings& warnings, std::optional<Weld> known = std::nullopt);

/// Merges adjacent coplanar faces of one object and material into polygons with holes.
void merge_coplanar_faces(Scene& scene);

}  // namespace ligne
