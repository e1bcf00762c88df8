#pragma once
/// From the model to the page and back. Everything that is checked lives in a unit box: the model's bounding box moved to
/// the origin and scaled to a longest side of 1, so that the float32 boxes of the ray caster are as fine as they can be.

#include <glm/mat4x4.hpp>

#include "geometry/point.hpp"
#include "support/standard.hpp"

namespace ligne::check {

/// Model coordinates p -> unit box coordinates (p - centre) / size.
struct UnitBox {
  Point3 centre{0, 0, 0};
  double size = 1;

  Point3 into(const Point3& p) const { return (p - centre) / size; }
  Point3 out_of(const Point3& q) const { return q * size + centre; }
};

/// The way from a point to the viewer.
struct Sightline {
  Point3 direction{0, 0, 1};  ///< unit length
  double length = 0;          ///< to the near plane; infinite in parallel projection
};

/// A part [from, to] of a segment's parameter range.
struct Part {
  double from = 0, to = 1;
};

/// 4 x 4 matrix, row by row.
using Rows = std::array<std::array<double, 4>, 4>;

class PageMap {
 public:
  /// `model_to_page` maps (x, y, z, 1) to (X, Y, Z, W): page mm (X/W, Y/W), depth Z/W growing away from the viewer. `window`
  /// is the part of the page on which something can be drawn. `near_distance` is the smallest W in perspective. Throws
  /// std::runtime_error when the matrix can not be inverted.
  PageMap(const Rows& model_to_page, const UnitBox& box, const Rect& window, double near_distance);

  bool perspective() const { return perspective_; }
  const Rect& window() const { return window_; }
  glm::dvec4 homogeneous(const Point3& q) const { return to_page_ * glm::dvec4(q, 1); }
  /// The page point of a point before the near plane.
  Point2 page(const Point3& q) const;
  /// The point of the same depth whose page point lies `mm` away.
  Point3 shifted(const Point3& q, Point2 mm) const;
  Sightline to_viewer(const Point3& q) const;
  /// A point of the sight through a page point, within or before the unit box, and the sight's direction away from the
  /// viewer.
  std::pair<Point3, Point3> sight_through(Point2 mm) const;
  /// The part of a segment that lies before the viewer and in the window less `margin_mm`.
  std::optional<Part> clip(const Point3& a, const Point3& b, double margin_mm) const;

 private:
  Point3 unproject(double x, double y, double z) const;

  glm::dmat4 to_page_{}, to_box_{};
  Rect window_;
  bool perspective_ = false;
  double near_ = 0;
  Point3 viewer_{0, 0, 0};  ///< the eye, or the direction to the viewer
};

/// Parameter on the segment in space of the point at parameter u of its image, wa and wb being W at its ends.
inline double parameter_in_space(double u, double wa, double wb) { return u * wa / (u * wa + (1 - u) * wb); }

}  // namespace ligne::check
