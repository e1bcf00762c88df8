#pragma once
/// The projected scene: what every visibility method starts from.

#include <cstdint>
#include <vector>

#include "drawing/stroke.hpp"
#include "geometry/lattice.hpp"
#include "scene/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// A vertex on the page lattice with its depth (see View::model_to_page). Depth is linear over the plane of a face.
struct ProjectedVertex {
  LatticePoint p;
  double z = 0;
};

/// A candidate edge: a line that is drawn where it is visible.
struct ProjectedEdge {
  std::uint32_t v0 = 0, v1 = 0;  ///< projected vertices
  std::uint32_t source = 0;      ///< edge of the topology
  LineClass line_class = LineClass::mesh;
};

struct EdgeSelection {
  LineClasses classes;
  double crease_degrees = 30;
};

/// The scene as the camera sees it. Vertices [0, scene vertices) are those of the scene, vertices after them were made by
/// clipping. Triangles without area on the lattice (seen edge on) are kept: their edges are lines too.
struct ProjectedScene {
  Lattice lattice;
  View view;
  std::vector<ProjectedVertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<ProjectedEdge> edges;  ///< candidates of the selected classes, ordered by source
  bool with_intersections = false;   ///< the selection has class intersection
  /// Error of the input's own coordinates on the page, in lattice steps (x and y alike), and in depth at the nearest
  /// vertex: surfaces closer than this touch. See docs/numerics.md.
  double input_error_steps = 0;
  double input_error_depth = 0;
};

/// Projects, clips to the view's window and near plane, snaps to the lattice, and classifies the edges.
ProjectedScene project(const Scene& scene, Topology&& topology, const View& view, const EdgeSelection& selection);

}  // namespace ligne
