#pragma once
/// The convex bodies of a scene as inequalities on the page.
///
/// A body is a connected closed part of an object, or a single flat face. [Roberts1963] writes the inside of a body as
/// linear inequalities, one for each face, and asks of a point of an edge whether a point on the way to the eye satisfies
/// all of them. With the eye at infinity along the depth, as it is on the page, the unknown on that way drops out, and a
/// point is hidden by a body when and only when
/// - it lies inside the body's silhouette, a convex polygon: one inequality for each of its sides, exact on the lattice;
/// - it lies behind the plane of each face that looks at the viewer.

#include <cstdint>
#include <string>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/box_forest.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::roberts {

struct Body {
  std::uint32_t hull_begin = 0, hull_end = 0;    ///< corners of its silhouette, in Bodies::hull
  std::uint32_t front_begin = 0, front_end = 0;  ///< facets of the faces that look at the viewer, in Bodies::front
  std::uint32_t plane_begin = 0, plane_end = 0;  ///< the largest facet of each of these faces, in Bodies::planes
  DepthBox box;
  float z_far = 0;         ///< farthest depth of its front
  float tolerance = 0;     ///< largest depth tolerance of its front
  std::uint32_t root = 0;  ///< tree of its front, in Bodies::forest, where it has many facets
  bool has_tree = false;
  std::uint32_t front_size() const { return front_end - front_begin; }
};

struct Bodies {
  std::vector<Body> list;
  std::vector<std::uint32_t> of_face;  ///< per face of the model: its body, or kNone
  std::vector<std::uint8_t> is_front;  ///< per face of the model: 1 when its outer side looks at the viewer
  std::vector<ProjectedVertex> vertices;
  std::vector<LatticePoint> hull;
  std::vector<Facet> front;           ///< corners are those of `vertices`
  std::vector<std::uint32_t> planes;  ///< indices into `front`
  Facets facets;                      ///< of all faces
  BoxForest forest;
  std::uint32_t root = 0;      ///< tree of all bodies, in `forest`
  std::size_t flat_faces = 0;  ///< bodies that are one face
  std::string unsupported;     ///< a part of the scene that is no convex body, and why; empty: there is none

  bool has_front(std::uint32_t body) const { return list[body].front_size() > 0; }
};

/// Finds the bodies in the scene's model, since the projected scene lacks faces that lie on others, and those that culling
/// left out. Bodies that are wholly out of view are left out. Parts that are no convex bodies are taken for one all the
/// same. O(n log n).
Bodies find_bodies(const ProjectedScene& scene, double coincidence_steps);

}  // namespace ligne::roberts
