#pragma once
/// Smooth curves on the page through the nodes of a contour.

#include <vector>

#include "contours/contour_chains.hpp"
#include "view/view.hpp"

namespace ligne {

/// Largest distance between a curve and the segments that approximate it, page mm. Even four times the accuracy of a
/// drawing, 0.001 mm, would not be visible.
inline constexpr double kCurveFlatnessMm = 0.002;

/// A point of a curve.
struct CurvePoint {
  double at = 0;  ///< parameter: i + t at the fraction t of segment i of its chain
  Point2 mm{0, 0};
  double depth = 0;   ///< as in View::model_to_page
  double weight = 1;  ///< homogeneous weight w
  double length = 0;  ///< arc length of the curve up to here, page mm
};

/// A curve as a polyline of close points.
struct ContourCurve {
  std::vector<CurvePoint> points;
  bool closed = false;

  double length() const { return points.empty() ? 0 : points.back().length; }
  CurvePoint point_at(double at) const;
  CurvePoint point_at_length(double length) const;
  /// The points between two parameters, including the points at both.
  std::vector<CurvePoint> part(double from, double to) const;
};

/// Removes parts of up to `longest_mm` where the line doubles back on itself, as the zero set does near a cusp.
void unfold(std::vector<CurvePoint>& line, double longest_mm);

/// The curve through the nodes of a chain on the smooth surface. Its tangents are perpendicular to the normals, and its
/// segments deviate from it by at most `flatness_mm`. At borders of its region it ends where the outline of the mesh
/// does.
ContourCurve contour_curve(const Scene& scene, const View& view, const ContourChain& chain, double flatness_mm);

/// The curve through points. Its tangent at a point has the direction from the previous point to the next one.
ContourCurve smooth_curve(const View& view, const std::vector<Point3>& points, bool closed, double flatness_mm);

}  // namespace ligne
