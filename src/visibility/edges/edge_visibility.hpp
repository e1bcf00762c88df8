#pragma once
/// Tests every edge against the faces that can hide it, in object space: the default method, and the last phase of
/// methods that first find an order of the faces.

#include <optional>
#include <vector>

#include "scene/model/topology.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/face_ranks.hpp"
#include "visibility/method.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// The first phases of edge_visibility(), where they do not depend on lines.
struct FaceStudy {
  Facets facets;
  std::optional<CellGrid> grid;  ///< of a study without ranks; only if the scene is with_intersections
  std::vector<Intersection> intersections;
};

/// `topology`: that of the scene, with which fewer facets are compared (joined_facets()); null where it is not at hand.
/// `hidden_strokes`: that of VisibilityOptions. `with_grid`: whether the grid is made, which takes memory.
FaceStudy study_faces(const ProjectedScene& scene, const Topology* topology, bool hidden_strokes, bool with_grid);

/// Finds the strokes, with statistics. `ranks` is an order of the scene's faces. With it a line is tested only against
/// faces that have pieces in front of its own, lines behind transparent faces get levels, and regions are given if
/// wanted: every face clipped by the faces before it in the order. Without it depths alone decide, and every face is
/// opaque.
VisibilityResult edge_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                 const FaceRanks* ranks = nullptr);

}  // namespace ligne
