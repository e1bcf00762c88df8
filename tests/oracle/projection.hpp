#pragma once
/// The exact projection.

#include "oracle/exact.hpp"
#include "oracle/oracle.hpp"

namespace oracle {

/// A point of the drawing plane with its depth, in units of its own that make all three coordinates rational: parallel (X,
/// Y, F), perspective (X / F, Y / F, -1 / F), with X = right . d, Y = down . d, F = forward . d of vectors that are not
/// normalized. Depth grows with the distance. Lines and planes stay lines and planes.
struct PagePoint {
  Exact x, y, z;
};

/// The plane z = a + b x + c y.
struct PagePlane {
  Exact a, b, c;
  Exact z(const Exact& x, const Exact& y) const { return a + b * x + c * y; }
};

/// X, Y, F of a point of the model.
struct SightPoint {
  Exact x, y, f;
};

class Projection {
 public:
  explicit Projection(const View& view);

  bool perspective() const { return perspective_; }
  const Vector3& eye() const { return eye_; }
  const Vector3& forward() const { return forward_; }

  SightPoint sight_point(const Vector3& p) const;
  /// In perspective: nearer than the near plane, so that it can not be drawn.
  bool too_near(const SightPoint& p) const { return perspective_ && p.f < near_; }
  const Exact& near() const { return near_; }
  /// Requires a point that is not too near.
  PagePoint page_point(const SightPoint& p) const;

  /// The plane through `on_plane` with the normal; `edge_on` when the page sees a line of it, and then nothing is returned:
  /// in perspective when the eye is not farther from it than `eye_error`, in model units.
  PagePlane page_plane(const Vector3& normal, const Vector3& on_plane, double eye_error, bool& edge_on) const;

  /// The model point that is drawn at the page point.
  Vector3 model_point(const PagePoint& p) const;

  // Millimetres of the page for one unit of x, y and depth; and the page's own coordinates.
  double mm_x() const { return mm_x_; }
  double mm_y() const { return mm_y_; }
  double mm_z() const { return mm_z_; }
  Point2 page_mm(const PagePoint& p) const {
    return {offset_.x + mm_x_ * to_double(p.x), offset_.y + mm_y_ * to_double(p.y)};
  }
  double depth_mm(const Exact& z) const { return depth_0_ + mm_z_ * to_double(z); }
  double x_of(double page_x_mm) const { return (page_x_mm - offset_.x) / mm_x_; }
  double y_of(double page_y_mm) const { return (page_y_mm - offset_.y) / mm_y_; }
  /// Page mm per model unit at the point, over that at the target: 1 in parallel projection.
  double magnification(const PagePoint& p) const;

 private:
  bool perspective_;
  Vector3 eye_, right_, down_, forward_;
  Exact near_;
  Exact right2_, down2_, forward2_;  ///< squares of the lengths
  double mm_x_, mm_y_, mm_z_, depth_0_;
  Point2 offset_;
};

}  // namespace oracle
