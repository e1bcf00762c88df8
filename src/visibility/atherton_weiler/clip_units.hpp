#pragma once
/// Units that the classical study clips as one: a face, or the silhouette of a convex body.

#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::atherton_weiler {

/// A rectangle of the page, in steps.
struct PageBox {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  void extend(const PageBox& o) {
    x0 = x0 < o.x0 ? x0 : o.x0;
    y0 = y0 < o.y0 ? y0 : o.y0;
    x1 = x1 > o.x1 ? x1 : o.x1;
    y1 = y1 > o.y1 ? y1 : o.y1;
  }
  bool meets(const PageBox& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};
/// The box that both hold.
inline PageBox common(const PageBox& a, const PageBox& b) {
  return {a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0, a.x1 < b.x1 ? a.x1 : b.x1, a.y1 < b.y1 ? a.y1 : b.y1};
}
PageBox box_of(const std::vector<ContourFace>& faces);
PageBox box_of(const Facet& facet, const std::vector<ProjectedVertex>& vertices);

/// A detail of a unit: a face of the scene, with its facets.
struct UnitFace {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> facets;
  std::vector<ContourFace> outline;
};

struct ClipUnit {
  std::vector<UnitFace> faces;       ///< one, or the front faces of a convex body
  std::vector<ContourFace> outline;  ///< all of them together: the silhouette
  PageBox box;
  double z_near = 0, z_far = 0;  ///< depths, each widened by the depth tolerance
  bool transparent = false;
  bool body = false;
};

/// The units of a scene, by their lowest facet. Facets are those of the scene. With `silhouettes` the front faces of every
/// convex closed body of opaque faces are one unit, and its back faces none: nothing of them is seen. A body is what hangs
/// together by vertices. It is closed when every side of its triangles has one other triangle, and convex when none of its
/// vertices is in front of the plane of a front face, or behind that of a back face, by more than the depth tolerance.
/// Where rounding to the lattice lets its front faces overlap, or its back faces look out, it is taken apart.
std::vector<ClipUnit> clip_units(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes);

}  // namespace ligne::atherton_weiler
