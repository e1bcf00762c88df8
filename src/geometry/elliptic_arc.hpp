#pragma once
/// Ellipses and their arcs on the page.

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// The points centre + R (radii.x cos t, radii.y sin t), where R rotates by `rotation` from x towards y and t is the
/// eccentric angle. Parallel projection takes equal steps on a circle to equal steps of t.
struct Ellipse {
  Point2 centre{0, 0};
  Point2 radii{1, 1};   ///< above zero, the longer first
  double rotation = 0;  ///< radians
};

Point2 point_at(const Ellipse& ellipse, double t);

/// An ellipse prepared for many queries. In its frame the ellipse is the unit circle.
class EllipseFrame {
 public:
  explicit EllipseFrame(const Ellipse& ellipse);

  Point2 to_unit(Point2 p) const;
  Point2 point_at(double t) const;
  /// Derivative of point_at.
  Point2 tangent_at(double t) const;
  /// Distance of a point given in the frame from the ellipse, to first order: valid for points much nearer than the radius
  /// of curvature.
  double distance(Point2 unit) const;
  /// Eccentric angle of the point of the ellipse that is nearest to `p`, to first order in its distance, within half a turn
  /// of angle_of().
  double nearest_angle(Point2 p) const;

 private:
  Ellipse ellipse_;
  Point2 axis_;  ///< the direction of the longer radius
};

/// Eccentric angle of the point where the ray from the centre through a point of the frame meets the ellipse.
double angle_of(Point2 unit);

/// The part of an ellipse from the eccentric angle `from` over `sweep`, in radians, positive from x towards y.
struct EllipticArc {
  Ellipse ellipse;
  double from = 0, sweep = 0;
};

/// Fit the circle or the ellipse that is nearest to the points in algebraic distance. Return false if there is none.
///
/// Circle: [Kasa1976]. Ellipse: [HalirFlusser1998], the stable form of
/// [FitzgibbonPiluFisher1999], in coordinates whose covariance is the unit matrix. Affine maps change the constraint
/// 4ac - b^2 = 1 only by a factor, so the result is the same, and slender or short arcs lose no digits.
bool fit_circle(std::span<const Point2> points, Ellipse& circle);
bool fit_ellipse(std::span<const Point2> points, Ellipse& ellipse);

/// Cubic Bezier curves within `tolerance` of the arc: three points for each, after the start of the arc.
std::vector<Point2> bezier_points(const EllipticArc& arc, double tolerance);

}  // namespace ligne
