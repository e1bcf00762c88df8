#pragma once
/// Units that the classical study clips as a whole: a face, or the silhouette of a convex body.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygons/contour_face.hpp"
#include "geometry/polygons/convex_clip.hpp"
#include "visibility/atherton_weiler/polygon_options.hpp"
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
  std::vector<UnitFace> faces{};       ///< one face, or the front faces of a convex body
  std::vector<ContourFace> outline{};  ///< the union of the faces: the silhouette
  PageBox box{};
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

/// Clips one subject after the other. One per task: it keeps its working memory.
class PolygonClip {
 public:
  PolygonClip(ClipKind kind, PolygonCounts& counts) : kind_(kind), counts_(counts) {}

  /// Divides the faces of the subject by the union of the clip faces. The faces of either do not overlap each other. Returns
  /// whether some of the subject is inside. `subject` must live until take_outside().
  bool divide(std::span<const ContourFace> subject, std::span<const ContourFace> clip);

  /// The parts found by divide(), once each; see clip_contour_by_contour(). Faces known to be convex are marked.
  std::vector<ContourFace> take_inside() { return std::move(inside_); }
  std::vector<ContourFace> take_outside();

 private:
  void divide_general(std::span<const ContourFace> subject, std::span<const ContourFace> clip);
  void divide_convex(const ContourFace& subject, const ContourFace& clip);

  ClipKind kind_;
  PolygonCounts& counts_;
  ConvexClip convex_;
  std::vector<ContourFace> inside_, outside_;
  std::vector<const ContourFace*> untouched_;  ///< faces of the subject that lie apart from the clip face
  std::vector<ContourFace> rest_;              ///< faces of the subject for the general clip
};

}  // namespace ligne::atherton_weiler
