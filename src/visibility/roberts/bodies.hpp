#pragma once
/// The convex bodies of a scene as inequalities on the page.
///
/// A body is a connected closed part of an object, or a single flat face. [Roberts1963] writes the inside of a body as
/// linear inequalities, one for each face. He tests whether some point between a point of an edge and the eye satisfies
/// all of them. On the page the eye is at infinity along the depth, so the unknown point drops out. A body hides a
/// point if and only if the point
/// - lies inside the body's silhouette, a convex polygon: one inequality for each of its sides, exact on the lattice;
/// - lies behind the plane of each front face.

#include <cstdint>
#include <string>
#include <vector>

#include "visibility/common/box_forest.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::roberts {

struct Body {
  std::uint32_t hull_begin = 0, hull_end = 0;    ///< corners of its silhouette, in Bodies::hull
  std::uint32_t front_begin = 0, front_end = 0;  ///< facets of its front faces, in Bodies::front
  std::uint32_t plane_begin = 0, plane_end = 0;  ///< the largest facet of each front face, in Bodies::planes
  DepthBox box;
  float z_far = 0;         ///< farthest depth of its front
  float tolerance = 0;     ///< largest depth tolerance of its front
  std::uint32_t root = 0;  ///< tree of its front, in Bodies::forest, if it has many facets
  bool has_tree = false;
  std::uint32_t front_size() const { return front_end - front_begin; }
};

struct Bodies {
  std::vector<Body> list;
  std::vector<std::uint32_t> of_face;  ///< per face of the model: its body, or kNone
  std::vector<std::uint8_t> is_front;  ///< per face of the model: 1 if its outer side faces the viewer
  std::vector<ProjectedVertex> vertices;
  std::vector<LatticePoint> hull;
  std::vector<Facet> front;           ///< facets of front faces, by body; corners are indices into `vertices`
  std::vector<std::uint32_t> planes;  ///< indices into `front`
  Facets facets;                      ///< facets of all faces
  BoxForest forest;
  std::uint32_t root = 0;      ///< tree of all bodies, in `forest`
  std::size_t flat_faces = 0;  ///< bodies with one face only
  std::string unsupported;     ///< names a part of the scene that is not a convex body, and the reason; empty if there
                               ///< is none

  bool has_front(std::uint32_t body) const { return list[body].front_size() > 0; }
};

/// Finds the bodies in the scene's model, as the projected scene lacks coincident faces and culled ones. Bodies wholly
/// out of view are left out. Parts in view that are not convex bodies become bodies all the same. O(n log n).
Bodies find_bodies(const ProjectedScene& scene, double coincidence_steps);

}  // namespace ligne::roberts
