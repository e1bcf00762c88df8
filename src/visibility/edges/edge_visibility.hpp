#pragma once
/// Tests every edge against the faces that can hide it, in object space: the default method, and the last phase of
/// methods that first find an order of the faces.

#include "visibility/common/face_ranks.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Finds the strokes, with statistics. `ranks` is an order of the scene's faces. With it a line is tested only against
/// faces that have pieces in front of its own, lines behind transparent faces get levels, and regions are given if
/// wanted: every face clipped by the faces before it in the order. Without it depths alone decide, and every face is
/// opaque.
VisibilityResult edge_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                 const FaceRanks* ranks = nullptr);

}  // namespace ligne
