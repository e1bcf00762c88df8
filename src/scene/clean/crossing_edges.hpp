#pragma once
/// Edges along which sheets of surfaces pass through each other.

#include "scene/model/scene.hpp"

namespace ligne {

/// Marks with kCornerCrossing every edge at which two sheets cross: faces of two objects that have an edge in common, or of
/// one object where more than two meet, lie round it in turns, so that each sheet has a face on either side of the other.
/// Visibility methods find the lines in which faces penetrate; surfaces sampled at the same places often cross along edges
/// of their own, where no face is pierced. Sheets that touch and part again, or run together on one side, do not cross.
///
/// Vertices of different objects are one when they lie within `distance` (model units) of each other, and directions are
/// equal when that moves one onto the other. The scene must be of triangles; finished objects (scene/clean.hpp). Edges that
/// only overlap in part are not seen.
void mark_crossing_edges(Scene& scene, double distance);

}  // namespace ligne
