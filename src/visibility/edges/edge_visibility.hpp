#pragma once
/// Every edge against the faces that can hide it, in object space: the study of the default method, and the last phase of
/// methods that find an order of the faces first.

#include "visibility/common/face_ranks.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Strokes, with their counts and times. `ranks`: the order of the faces of the scene; a line is then only compared with
/// faces that have pieces before its own. Without it depths alone decide, and every face is opaque. With it lines behind
/// transparent faces have levels, and regions are given where they are wanted: every face clipped by those before it in the
/// order.
VisibilityResult edge_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                 const FaceRanks* ranks = nullptr);

}  // namespace ligne
