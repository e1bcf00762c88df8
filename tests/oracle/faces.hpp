#pragma once
/// The scene's faces and edges as the oracle sees them.

#include <array>
#include <vector>

#include "oracle/projection.hpp"

namespace oracle {

/// Certain bounds on the page, in the units of PagePoint.
struct Box {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300, z0 = 1e300, z1 = -1e300;

  void add(const PagePoint& p);
  bool meets(const Box& other, double margin_x, double margin_y) const {
    return x0 - margin_x <= other.x1 && other.x0 <= x1 + margin_x && y0 - margin_y <= other.y1 && other.y0 <= y1 + margin_y;
  }
};

struct Face {
  Vector3 normal, centre;  ///< its plane: Newell's normal of the outer contour, through the mean of its corners
  bool flat = false;       ///< without area: it has no plane
  int facing = 0;          ///< +1 looks at the viewer, -1 away, 0 is seen edge on
  bool facing_sure = true;

  // On the page, cut off before the near plane. Contours one after the other; points inside have an odd number of sides
  // to their left.
  bool hides = false;  ///< has area on the page
  bool clear = false;  ///< transparent, and nothing counts as hidden by it
  std::vector<PagePoint> corners;
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< corners from and to
  std::vector<Point2> corners_mm;                   ///< the corners on the page, rounded
  PagePlane plane;
  Box box;
  double gradient = 0;  ///< mm of depth by mm of the page
  double slack_mm = 0;  ///< how far in depth the corners are off the plane
};

/// Faces whose plane is nearer to the eye than `input_error`, in model units, are seen edge on.
std::vector<Face> make_faces(const ligne::Scene& scene, const Projection& projection, double input_error);

/// Edges by object and position, classes included.
std::vector<Edge> make_edges(const ligne::Scene& scene, const std::vector<Face>& faces, double crease_degrees);

}  // namespace oracle
