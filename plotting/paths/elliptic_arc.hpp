#pragma once
/// Ellipses and their arcs on the page.

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// The points centre + R (radii.x cos t, radii.y sin t), R a turn by `rotation` from x towards y. t is the eccentric angle.
/// Equal steps of t are what equal steps on a circle become in parallel projection.
struct Ellipse {
  Point2 centre{0, 0};
  Point2 radii{1, 1};   ///< above zero, the longer first
  double rotation = 0;  ///< radians
};

Point2 point_at(const Ellipse& ellipse, double t);
/// Derivative of point_at.
Point2 tangent_at(const Ellipse& ellipse, double t);
/// Distance of `p` from the ellipse, to first order: right for what is much nearer than the radius of curvature.
double distance(const Ellipse& ellipse, Point2 p);

/// An ellipse of which much is asked: its frame is that in which it is the unit circle.
class EllipseFrame {
 public:
  explicit EllipseFrame(const Ellipse& ellipse);

  Point2 to_unit(Point2 p) const;
  /// As above.
  Point2 tangent_at(double t) const;
  /// The distance of a point in the frame, as above.
  double distance(Point2 unit) const;

 private:
  Ellipse ellipse_;
  Point2 axis_;  ///< the direction of the longer radius
};

/// Eccentric angle of the point where the ray from the centre through a point of the frame meets the ellipse.
double angle_of(Point2 unit);

/// From the angle `from` over `sweep`, which is positive from x towards y.
struct EllipticArc {
  Ellipse ellipse;
  double from = 0, sweep = 0;
};

/// The ellipse and the circle nearest to the points, in the sense of the algebraic distance. False when there is none.
///
/// Circle: [Taubin1991], by Newton's method as in [ChernovLesort2005]. Ellipse: [HalirFlusser1998], the stable form of
/// [FitzgibbonPiluFisher1999], in coordinates of which the covariance is one. The constraint 4ac - b^2 = 1 does not change
/// under affine maps but for a factor, so the result is the same, and slender or short arcs lose no digits.
bool fit_circle(std::span<const Point2> points, Ellipse& circle);
bool fit_ellipse(std::span<const Point2> points, Ellipse& ellipse);

/// The shorter arc of an ellipse of this size and direction that begins and ends at exactly these points, as SVG's command A
/// has it; the ellipse is enlarged as there when it does not reach. `positive`: it turns from x towards y.
EllipticArc arc_between(Point2 from, Point2 to, const Ellipse& size, bool positive);

/// Bezier curves of the third degree: three points each, behind the start of the arc. None is farther than
/// `tolerance` from the arc.
std::vector<Point2> bezier_points(const EllipticArc& arc, double tolerance);

}  // namespace ligne
