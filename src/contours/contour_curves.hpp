#pragma once
/// Contours as smooth curves on the page.

#include <cstdint>
#include <vector>

#include "contours/contour_chains.hpp"
#include "view/view.hpp"

namespace ligne {

/// Pieces of a curve are straight to this; four times the accuracy that drawings owe would still not be seen.
inline constexpr double kCurveFlatnessMm = 0.002;

/// A point of a curve. `at`: i + t at the fraction t of segment i of its chain.
struct CurvePoint {
  double at = 0;
  Point2 mm{0, 0};
  double depth = 0;   ///< as in View::model_to_page
  double weight = 1;  ///< homogeneous w
  double length = 0;  ///< mm of the curve up to here
};

struct ContourCurve {
  std::vector<CurvePoint> points;
  bool closed = false;

  double length() const { return points.empty() ? 0 : points.back().length; }
  CurvePoint point_at(double at) const;
  CurvePoint point_at_length(double length) const;
  /// The points between two places, and these.
  std::vector<CurvePoint> part(double from, double to) const;
};

/// Takes out places where the line turns back on itself for less than `longest_mm`: near a cusp the zero set runs to and
/// fro.
void unfold(std::vector<CurvePoint>& line, double longest_mm);

/// The chain on the smooth surface, as a curve whose tangents lie across the normals, in pieces that are straight to
/// `flatness_mm`. At borders of its region it ends where the outline of the mesh does.
ContourCurve contour_curve(const Scene& scene, const View& view, const ContourChain& chain, double flatness_mm);

/// The curve through points, whose tangents have the direction from the one before to the one behind.
ContourCurve smooth_curve(const View& view, const std::vector<Point3>& points, bool closed, double flatness_mm);

}  // namespace ligne
