#pragma once
/// The plane on which curves are compared with the horizon.

#include <glm/geometric.hpp>

#include "view/view.hpp"

namespace ligne::horizon {

/// A point projected to an upright drawing plane, on which verticals stay vertical for any tilt of the camera. Hiding
/// depends only on the lines of sight, so any plane serves, and on this one the horizon is a function of u.
struct PlanePoint {
  double x, y;  ///< to the right and upwards, before the division by w
  double w;     ///< distance from the viewer along the plane's normal; 1 in parallel projection
  double u() const { return x / w; }
  double v() const { return y / w; }
};

/// The projection of one part of the grid: in perspective, of all points with sign_x (x - eye_x) >= 0 and sign_y (y -
/// eye_y) >= 0.
class PlaneProjection {
 public:
  PlaneProjection(const Camera& camera, double sign_x, double sign_y);

  PlanePoint operator()(const Point3& p) const {
    const Point3 d = p - eye_;
    if (!perspective_) return {glm::dot(right_, d), glm::dot(up_, d), 1};
    return {glm::dot(right_, d), d.z, glm::dot(forward_, d)};
  }

  bool perspective() const { return perspective_; }

 private:
  bool perspective_;
  Point3 eye_, right_, up_, forward_;
};

/// Fraction of a segment in space at the fraction s on the drawing plane; see source_parameter in linework/stroke.hpp.
inline double fraction_in_space(double w0, double w1, double s) {
  const double numerator = s * w0;
  return numerator / ((1 - s) * w1 + numerator);
}

}  // namespace ligne::horizon
