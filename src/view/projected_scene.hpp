#pragma once
/// The projected scene: the input of every visibility method.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/lattice.hpp"
#include "linework/stroke.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// A vertex on the page lattice with its depth (see View::model_to_page). Depth is a linear function of the page
/// coordinates over the plane of a face.
struct ProjectedVertex {
  LatticePoint p;
  double z = 0;
};

/// A candidate: a line that is drawn where it is visible. Most candidates are edges of the scene.
struct ProjectedEdge {
  std::uint32_t v0 = 0, v1 = 0;                ///< indices of projected vertices
  std::uint32_t face0 = kNone, face1 = kNone;  ///< its first two faces, kNone if there are fewer
  std::uint32_t source = 0;                    ///< edge of the topology, or number of an added line (add_lines)
  LineClass line_class = LineClass::mesh;
};

/// Value of ProjectedScene::face_is_transparent.
inline constexpr std::uint8_t kClearFace = 2;

/// Which edges become candidates.
struct EdgeSelection {
  LineClasses classes;
  double crease_degrees = 30;
  const std::vector<std::uint8_t>* creases = nullptr;  ///< per edge, see crease_lines.hpp; null: by angle
  const TriangleShapes* shapes = nullptr;              ///< of the scene; null: not known
  bool no_edges = false;                               ///< whether none does
};

/// The scene as the camera sees it. Vertices are renumbered along a Morton curve over the page; faces and source edges
/// keep their numbers in the scene. Triangles without area on the lattice (seen edge on) are kept, since their edges
/// may be visible lines.
struct ProjectedScene {
  /// The scene itself, for methods that work in model space. It must outlive the method's run.
  const Scene* model = nullptr;
  Lattice lattice{};
  View view{};
  std::vector<ProjectedVertex> vertices{};
  std::vector<Triangle> triangles{};   ///< clipped to the volume of faces (clip.hpp); indices are into `vertices`
  std::vector<ProjectedEdge> edges{};  ///< candidates of the selected classes, clipped to the volume of lines (clip.hpp)
  /// Per candidate: the parameters on its source edge between which it lies inside the view volume. Empty if no edge
  /// was clipped.
  std::vector<std::array<double, 2>> edge_parts{};
  std::uint32_t source_count = 0;   ///< number of sources: edges of the topology plus added lines
  bool with_intersections = false;  ///< the selection includes LineClass::intersection
  /// Per face of the scene: 0 opaque; 1 transparent, counted by Stroke::level; kClearFace transparent and not counted.
  /// Empty if all faces are opaque. Methods without transparency treat every face as opaque.
  std::vector<std::uint8_t> face_is_transparent{};
  /// Per face of the scene: 1 if it is seen edge on (edge_on.hpp). Its triangles hide nothing, even if rounding to the
  /// lattice gives them an area. Empty if there is no such face.
  std::vector<std::uint8_t> face_is_edge_on{};
  /// Per vertex: the lowest vertex with the same position and depth; coincident parts have separate vertices. Empty if
  /// no two vertices share a position. See coincident.hpp.
  std::vector<std::uint32_t> first_at_place{};
  std::uint32_t place(std::uint32_t vertex) const {
    return vertex < first_at_place.size() ? first_at_place[vertex] : vertex;  // later vertices are ends of added lines
  }
  /// Removes the candidates i for which drop(i) holds.
  template <class Drop>
  void erase_edges(const Drop& drop) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (drop(i)) continue;
      edges[kept] = edges[i];
      if (!edge_parts.empty()) edge_parts[kept] = edge_parts[i];
      ++kept;
    }
    edges.resize(kept);
    if (!edge_parts.empty()) edge_parts.resize(kept);
  }
  bool is_edge_on(const Triangle& t) const { return !face_is_edge_on.empty() && face_is_edge_on[t.face]; }

  /// Rounding error of the input coordinates in page mm at the target plane. Surfaces closer than this touch.
  double input_error_mm = 0;

  /// Ratio of the scale (page mm per model unit) at depth z to that at the target plane; 1 in parallel projection.
  /// Errors in x and y are proportional to it, errors in depth to its square.
  double magnification(double z) const {
    return view.camera.perspective ? 1 - z / (view.scale * view.camera.target_distance) : 1;
  }
};

/// The first half of project(): classifies the edges, and selects the candidates by their classes. Vertices and
/// triangles are still empty, and edges have vertex indices of the scene.
ProjectedScene select_candidates(const Scene& scene, const Topology& topology, const View& view,
                                 const EdgeSelection& selection);

/// The second half of project(): projects, clips lines to the window and the near plane of the view and faces to
/// slightly more (clip.hpp), and snaps to the lattice. It drops candidates that are out of view or coincide with
/// another candidate.
void place_on_page(const Scene& scene, const Topology& topology, ProjectedScene& projected);

/// Pairs (face, lower face that replaces it), ascending.
using ReplacedFaces = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// New numbers of vertices and faces of the scene.
struct PlacedNumbers {
  std::vector<std::uint32_t> vertices;
  ReplacedFaces faces;
};

/// The part of place_on_page() that does not depend on candidates. Returns nothing if a part of the scene is out of view:
/// that part must be clipped.
std::optional<PlacedNumbers> place_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected);

/// The other part of place_on_page().
void place_candidates(const PlacedNumbers& numbers, ProjectedScene& projected);

/// Calls select_candidates() and place_on_page().
ProjectedScene project(const Scene& scene, const Topology& topology, const View& view, const EdgeSelection& selection);

/// ProjectedScene::input_error_mm for coordinates of this precision (Object::precision) and with the largest absolute
/// value `largest`, both in model units.
double projected_error_mm(const View& view, double precision, double largest);

/// Per face of the scene: 1 if its material is transparent, else 0. Empty if there is no such material.
std::vector<std::uint8_t> transparent_faces(const Scene& scene);

/// Adds lines in model space, which are edges of no face, as candidates of class `line_class`. Line i gets the source
/// `source_count` + i. Parts out of view are clipped away.
void add_lines(ProjectedScene& projected, std::span<const std::array<Point3, 2>> lines, LineClass line_class);

}  // namespace ligne
