#pragma once
/// Points of a face, carried from the page of one view to that of another.

#include <vector>

#include <glm/geometric.hpp>

#include "geometry/lattice.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

struct FacePlane {
  Point3 normal, point;
};

inline FacePlane plane_of(const Scene& scene, std::uint32_t face) {
  return {face_normal(scene, face), scene.vertices[scene.faces.contour(face, 0)[0]]};
}

/// On which side of the face's plane the eye is: the sign.
inline double side_of_eye(const Camera& camera, const FacePlane& plane) {
  return camera.perspective ? glm::dot(plane.normal, camera.eye - plane.point) : -glm::dot(plane.normal, camera.forward);
}

/// The point of the plane that is drawn at the page point. False when the sight runs along the plane.
inline bool point_on_face(const View& view, Point2 page_mm, const FacePlane& plane, Point3& out) {
  const double far_depth =
      view.camera.perspective ? 0.5 * view.scale * view.camera.target_distance : 100;  // any depth but 0
  const Point3 a = to_model_point(view, page_mm, 0), b = to_model_point(view, page_mm, far_depth);
  const double rise = glm::dot(plane.normal, b - a);
  if (rise == 0) return false;
  out = a + (b - a) * (glm::dot(plane.normal, plane.point - a) / rise);
  return true;
}

/// The corners on the page of what of a contour is in view; none when nothing is. The contour may be concave: its pieces in
/// view are then joined along the border of the view, there and back.
std::vector<LatticePoint> points_in_view(std::vector<HomogeneousPoint> contour, const View& view, const Lattice& lattice);

/// Where a contour on the face's plane lies on another page, as far as it is in view there. False when it can not be drawn,
/// since the sight runs along the face.
bool carry(const View& from, const std::vector<Point2>& contour_mm, const FacePlane& plane, const View& to,
           const Lattice& lattice, std::vector<LatticePoint>& out);

/// The border of a face on a page. What another view sees of the face ends there too, but carried over it is rounded
/// otherwise, and slivers would be left between the two. So what runs along the border is moved beyond it, where the face
/// has nothing that could be cut.
class FaceBorder {
 public:
  /// A point nearer than `near_mm` lies on the border, and is moved as far beyond it.
  FaceBorder(const Scene& scene, std::uint32_t face, const View& view, const Lattice& lattice, double near_mm);

  void move_beyond(std::vector<LatticePoint>& contour) const;

 private:
  struct Edge {
    Point2 from, along;  ///< in steps
    Point2 out;          ///< unit vector that leads out of the face
  };

  bool lies_on(const Edge& edge, LatticePoint p) const;

  double near_;  ///< in steps
  std::vector<Edge> edges_;
};

}  // namespace ligne
