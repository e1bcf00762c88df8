#pragma once
/// Traits of a view of a scene: the numbers that the cost of the visibility methods depends on.
///
/// [Boulle1980] 2.3.7 and 2.6 name them; docs/compare.md explains them.

#include <cstddef>
#include <cstdint>

#include "picture/choice/face_pairs.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// A count that is stopped if it would take too long. The number is then a lower bound.
struct BoundedCount {
  std::uint64_t n = 0;
  bool complete = true;
};

struct SceneTraits {
  std::size_t faces = 0;              ///< faces with area on the page
  std::size_t front_faces = 0;        ///< those of `faces` that are wound towards the viewer
  std::size_t transparent_faces = 0;  ///< those of `faces` that are transparent
  BoundedCount visible_faces;         ///< those of `faces` that are in front at a sample point, see find_faces_in_front()
  double mean_corners = 0;            ///< of a face of `faces`, holes included
  std::size_t most_corners = 0;
  std::size_t nonconvex_faces = 0;   ///< those of `faces` with a hole or a reflex corner
  std::size_t convex_objects = 0;    ///< opaque closed convex bodies, connected by vertices and wholly in view
  std::size_t zones = 0;             ///< sets of faces connected by overlapping bounding boxes on the page
  std::size_t largest_zone = 0;      ///< number of faces in the largest zone
  BoundedCount penetrations;         ///< pairs of faces that pass through each other
  BoundedCount conflicts;            ///< pairs of faces with a common part of the page
  double mean_overlap = 0;           ///< mean number of faces over a point of the page that has any
  std::uint32_t most_overlap = 0;    ///< largest number of faces over a point
  std::size_t turning_vertices = 0;  ///< nbsom': vertices at which a contour of a face turns back, up or down the page
  /// Share of the picture, the rectangle round all faces, that has a face: at points of a grid.
  double covered_part = 0;
  double mean_visible_part =
      0;                      ///< mean projected area of the visible faces, hidden parts included, over that of the picture
  FaceSpread spread;          ///< how a sort along each axis of the view tells the faces apart
  bool height_field = false;  ///< no vertical line meets it twice, as far as samples of its plan show
};

/// `topology` belongs to the scene; `projected` is its projection with any selection of edges, and `up` the vertical axis
/// of the view. O(n log n); pairs are counted up to a bound. Faces that coincide with another one are left out, as in every
/// method.
SceneTraits scene_traits(const Scene& scene, const Topology& topology, const ProjectedScene& projected, Axis up);

}  // namespace ligne
