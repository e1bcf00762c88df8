#pragma once
/// The projected scene: what every visibility method starts from.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "drawing/stroke.hpp"
#include "geometry/lattice.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// A vertex on the page lattice with its depth (see View::model_to_page). Depth is linear over the plane of a face.
struct ProjectedVertex {
  LatticePoint p;
  double z = 0;
};

/// A candidate edge: a line that is drawn where it is visible.
struct ProjectedEdge {
  std::uint32_t v0 = 0, v1 = 0;                ///< projected vertices
  std::uint32_t face0 = kNone, face1 = kNone;  ///< its first two faces
  std::uint32_t source = 0;                    ///< edge of the topology, or a line beside it (add_lines)
  LineClass line_class = LineClass::mesh;
};

/// See ProjectedScene::face_is_transparent.
inline constexpr std::uint8_t kClearFace = 2;

struct EdgeSelection {
  LineClasses classes;
  double crease_degrees = 30;
  const std::vector<std::uint8_t>* creases = nullptr;  ///< per edge kCreaseLine, kTangentLine or 0; nullptr: by the angle
};

/// The scene as the camera sees it. Vertices are numbered along a Morton curve over the page, whatever their numbers in the
/// scene; faces and source edges keep the scene's numbers. Triangles without area on the lattice (seen edge on) are kept:
/// their edges are lines too.
struct ProjectedScene {
  /// The projected scene, for methods that work in model space. It must outlive the study.
  const Scene* model = nullptr;
  Lattice lattice;
  View view;
  std::vector<ProjectedVertex> vertices;
  std::vector<Triangle> triangles;   ///< what is inside the volume of faces; vertex indices are those of `vertices`
  std::vector<ProjectedEdge> edges;  ///< candidates of the selected classes, clipped to the volume of lines (clip.hpp)
  /// Where edges were clipped: per candidate edge the part of its source edge that is inside. Empty when nothing was.
  std::vector<std::array<double, 2>> edge_parts;
  std::uint32_t source_count = 0;   ///< number of edges of the topology, and of lines beside them
  bool with_intersections = false;  ///< the selection has class intersection
  /// Per face of the scene: 1 when what is behind is seen through it, kClearFace when it is seen but is not even in the way.
  /// Empty when all faces are opaque. Methods that know no transparency take every face for opaque.
  std::vector<std::uint8_t> face_is_transparent;
  /// Per face of the scene: 1 when it is seen edge on (edge_on.hpp). Its triangles hide nothing, also where the rounding to
  /// the lattice gives them an area. Empty when no face is.
  std::vector<std::uint8_t> face_is_edge_on;
  /// Per vertex the lowest vertex that has the same place and depth: parts that coincide have vertices of their own. Empty
  /// when no two vertices share a place. See coincident.hpp.
  std::vector<std::uint32_t> first_at_place;
  std::uint32_t place(std::uint32_t vertex) const {
    return vertex < first_at_place.size() ? first_at_place[vertex] : vertex;  // later vertices: ends of lines of no face
  }
  bool is_edge_on(const Triangle& t) const { return !face_is_edge_on.empty() && face_is_edge_on[t.face]; }

  /// Error of the input's own coordinates in page mm at the target plane: surfaces closer than this touch.
  double input_error_mm = 0;

  /// Page mm by model unit at depth z, over that at the target plane: 1 in parallel projection. Errors in x and y grow with
  /// it, errors in depth with its square.
  double magnification(double z) const {
    return view.camera.perspective ? 1 - z / (view.scale * view.camera.target_distance) : 1;
  }
};

/// The first half of project(): classifies the edges, and selects the candidates by their classes. Vertices and triangles
/// are not there yet, and edges have the vertices of the scene.
ProjectedScene select_candidates(const Scene& scene, const Topology& topology, const View& view,
                                 const EdgeSelection& selection);

/// The second half: projects, clips lines to the view's window and near plane and faces to a little more (clip.hpp), and
/// snaps to the lattice. Candidates that are out of view or lie on another one are left out.
void place_on_page(const Scene& scene, const Topology& topology, ProjectedScene& projected);

/// Both.
ProjectedScene project(const Scene& scene, const Topology& topology, const View& view, const EdgeSelection& selection);

/// ProjectedScene::input_error_mm of coordinates of that precision (Object::precision) and size.
double projected_error_mm(const View& view, double precision, double largest);

/// Per face of the scene 1 when its material is transparent, else 0; empty when there is no such material.
std::vector<std::uint8_t> transparent_faces(const Scene& scene);

/// Adds lines in model space that are edges of no face: candidates of class `line_class`, whose sources are numbered from
/// `source_count` upwards, in their order. What is out of view is left out.
void add_lines(ProjectedScene& projected, std::span<const std::array<Point3, 2>> lines, LineClass line_class);

}  // namespace ligne
