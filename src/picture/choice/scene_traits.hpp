#pragma once
/// Traits of a scene as it is seen: the figures on which the cost of the visibility methods depends.
///
/// [Boulle1980] 2.3.7 and 2.6 name them; docs/compare.md says what each means.

#include <cstddef>
#include <cstdint>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// A count that is given up where it would take too long: then there are at least so many.
struct BoundedCount {
  std::uint64_t n = 0;
  bool complete = true;
};

struct SceneTraits {
  std::size_t faces = 0;              ///< with an area on the page
  std::size_t front_faces = 0;        ///< of them, wound towards the viewer
  std::size_t transparent_faces = 0;  ///< of them
  std::size_t convex_objects = 0;     ///< opaque closed convex bodies that are wholly in view and hang together by vertices
  std::size_t zones = 0;              ///< sets of faces that hang together by overlapping boxes on the page
  std::size_t largest_zone = 0;       ///< faces in the largest
  BoundedCount penetrations;          ///< pairs of faces that pass through each other
  BoundedCount conflicts;             ///< pairs of faces that have a part of the page in common
  double mean_overlap = 0;            ///< faces over each other, on the average of the points of the page where there is one
  std::uint32_t most_overlap = 0;     ///< and at most, at these points
  std::size_t turning_vertices = 0;   ///< nbsom': vertices at which a contour of a face turns back, up or down the page
  bool height_field = false;          ///< no upright line meets it twice, as far as samples of its plan tell
};

/// `topology` is that of the scene; `projected` what is seen of it, whatever the selection of edges. O(n log n): pairs are
/// counted up to a bound. The faces that coincide with another one are left out, as they are for every method.
SceneTraits scene_traits(const Scene& scene, const Topology& topology, const ProjectedScene& projected);

}  // namespace ligne
