#pragma once
/// Units that the classical study clips as a whole: a face, or the silhouette of a convex body.

#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"
#include "visibility/common/facet.hpp"

namespace ligne::atherton_weiler {

/// A rectangle of the page, in lattice steps.
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
/// The intersection of two boxes.
inline PageBox common(const PageBox& a, const PageBox& b) {
  return {a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0, a.x1 < b.x1 ? a.x1 : b.x1, a.y1 < b.y1 ? a.y1 : b.y1};
}
PageBox box_of(const std::vector<ContourFace>& faces);
PageBox box_of(const Facet& facet, const std::vector<ProjectedVertex>& vertices);

/// A face of the scene with its facets, as a detail of a unit.
struct UnitFace {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> facets;
  std::vector<ContourFace> outline;
};

struct ClipUnit {
  std::vector<UnitFace> faces;       ///< one face, or the front faces of a convex body
  std::vector<ContourFace> outline;  ///< the union of the faces: the silhouette
  PageBox box;
  double z_near = 0, z_far = 0;  ///< depth range, widened by the depth tolerance
  bool transparent = false;
  bool body = false;
};

/// The units of a scene, sorted by their lowest facet. With `silhouettes` the front faces of every convex closed body of
/// opaque faces form one unit, and its back faces are omitted as invisible. A body is a set of triangles connected by
/// vertices. It is closed if every side of its triangles belongs to exactly two triangles. It is convex if no vertex lies in
/// front of the plane of a front face, or behind the plane of a back face, by more than the depth tolerance. A body is split
/// into its faces where rounding to the lattice makes front faces overlap or back faces visible.
std::vector<ClipUnit> clip_units(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes);

}  // namespace ligne::atherton_weiler
