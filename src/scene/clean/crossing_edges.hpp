#pragma once
/// Edges along which sheets of surfaces cross each other.

#include "scene/model/scene.hpp"

namespace ligne {

/// Marks every edge at which two sheets cross with kCornerCrossing. Sheets consist of faces of two objects that share
/// an edge, or of one object with more than two faces at the edge. They cross if their faces alternate around the edge,
/// so that each sheet has a face on either side of the other. Visibility methods find the lines in which faces
/// penetrate. But surfaces sampled at common places often cross along their own edges, where no face is pierced. Sheets
/// that touch and part again, or coincide on one side, do not cross.
///
/// Vertices of different objects count as equal if they lie within `distance` (model units) of each other; directions
/// are equal if moving vertices that far makes them coincide. Requires finished objects (scene/clean/clean.hpp) of triangles
/// only. Edges that overlap only in part are not found.
void mark_crossing_edges(Scene& scene, double distance);

}  // namespace ligne
