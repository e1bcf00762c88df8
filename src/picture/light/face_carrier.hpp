#pragma once
/// Maps points of a face from the page of one view to the page of another.

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

/// Positive or negative, depending on the side of the face's plane on which the eye is.
inline double side_of_eye(const Camera& camera, const FacePlane& plane) {
  return camera.perspective ? glm::dot(plane.normal, camera.eye - plane.point) : -glm::dot(plane.normal, camera.forward);
}

/// Finds the point of the plane that is drawn at the page point. Returns false if the line of sight is parallel to the
/// plane.
inline bool point_on_face(const View& view, Point2 page_mm, const FacePlane& plane, Point3& out) {
  const double far_depth =
      view.camera.perspective ? 0.5 * view.scale * view.camera.target_distance : 100;  // any depth but 0
  const Point3 a = to_model_point(view, page_mm, 0), b = to_model_point(view, page_mm, far_depth);
  const double rise = glm::dot(plane.normal, b - a);
  if (rise == 0) return false;
  out = a + (b - a) * (glm::dot(plane.normal, plane.point - a) / rise);
  return true;
}

/// Returns the corners on the page of the part of a contour in view; none if nothing is in view. If the contour is
/// concave, its pieces in view are joined along the border of the view, there and back.
std::vector<LatticePoint> points_in_view(std::vector<HomogeneousPoint> contour, const View& view, const Lattice& lattice);

/// Maps a contour in the face's plane to another page, clipped to the view there. Returns false if the line of sight is
/// parallel to the face.
bool carry(const View& from, const std::vector<Point2>& contour_mm, const FacePlane& plane, const View& to,
           const Lattice& lattice, std::vector<LatticePoint>& out);

/// The border of a face on a page. The parts of the face that another view sees end at this border too, but mapped to
/// this page they are rounded differently, and slivers would remain between the two. So contours along the border move
/// beyond it, where the face has nothing to cut.
class FaceBorder {
 public:
  /// `near_mm`: distance within which a point lies on the border, and by which it moves beyond it.
  FaceBorder(const Scene& scene, std::uint32_t face, const View& view, const Lattice& lattice, double near_mm);

  void move_beyond(std::vector<LatticePoint>& contour) const;

 private:
  struct Edge {
    Point2 from, along;  ///< lattice steps
    Point2 out;          ///< unit vector that points out of the face
  };

  bool lies_on(const Edge& edge, LatticePoint p) const;

  double near_;  ///< lattice steps
  std::vector<Edge> edges_;
};

}  // namespace ligne
