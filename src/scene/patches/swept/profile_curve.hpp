#pragma once
/// Plane curves through given points: the profiles of extruded and revolved surfaces.

#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "geometry/point.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// A curve through points with a continuous tangent. The tangent at a point is that of the circle through the point and both
/// of its neighbours; at an open end the curvature goes on as it changes behind it. Beyond its ends the curve is straight.
/// Its normals point to the right of its direction, (t.y, -t.x) for a tangent t, if +y is to the left of +x.
class ProfileCurve {
 public:
  /// The point of the curve nearest to another one.
  struct Foot {
    Point2 normal{0, 1};   ///< unit normal
    double distance = 0;   ///< signed, positive on the side of the normal
    double curvature = 0;  ///< positive where the curve bends away from its normal
  };

  /// At least two points, no two consecutive ones equal. A closed curve returns from the last one to the first.
  /// `is_mirrored`: an open end with x = 0 is followed by the mirror image of the curve, if that continues it smoothly: a
  /// pole of a surface of revolution.
  ProfileCurve(std::vector<Point2> points, bool is_closed, bool is_mirrored);

  /// O(log n) for usual curves.
  Foot foot(const Point2& p) const;

  const std::vector<Point2>& points() const { return points_; }
  bool is_closed() const { return is_closed_; }
  /// The curve times a positive factor.
  ProfileCurve scaled(double factor) const;

 private:
  static constexpr std::size_t kLeaf = 4;  ///< most segments of a leaf of the tree of boxes

  struct Nearest {
    std::size_t segment = 0;
    double square = 1e300;
  };
  struct Joint {
    double bend = 0, curvature = 0;
    Point2 tangent{1, 0};
  };

  std::size_t segment_count() const { return is_closed_ ? points_.size() : points_.size() - 1; }
  const Point2& at(std::size_t i) const { return points_[i < points_.size() ? i : i - points_.size()]; }
  const Joint& joint(std::size_t i) const { return joints_[i < joints_.size() ? i : i - joints_.size()]; }
  Point2 chord(std::size_t i) const { return at(i + 1) - at(i); }
  void set_inner_joints();
  void set_end(std::size_t end, std::size_t next, std::size_t after);
  void build_boxes(std::size_t node, std::size_t begin, std::size_t end);
  void find_nearest(const Point2& p, std::size_t node, std::size_t begin, std::size_t end, Nearest& best) const;
  Foot foot_on(const Point2& p, std::size_t segment) const;

  std::vector<Point2> points_;
  std::vector<Joint> joints_;  ///< per point
  std::vector<Rect> boxes_;    ///< of a binary tree over the segments: the children of node i are 2i + 1 and 2i + 2
  bool is_closed_ = false, is_mirrored_ = false;
};

/// A profile in the frame of its surface (PatchSurface::at):
/// - extruded: in the coordinates along x and y;
/// - revolved: in the distance from the axis and the coordinate along it.
struct SweptProfile {
  ProfileCurve curve;
  Point3 x{1, 0, 0}, y{0, 1, 0};  ///< unit vectors perpendicular to the axis and to each other; not used if revolved
};

/// The place of a point in the frame of the profile of a surface that has one.
inline Point2 profile_place(const PatchSurface& s, const Point3& p) {
  if (s.kind == SurfaceKind::revolved) {
    const Point3 way = p - s.at;
    const double along = glm::dot(way, s.axis);
    return {glm::length(way - along * s.axis), along};
  }
  return {glm::dot(p - s.at, s.profile->x), glm::dot(p - s.at, s.profile->y)};
}

/// The foot of a point on the profile of such a surface.
inline ProfileCurve::Foot swept_foot(const PatchSurface& s, const Point3& p) {
  return s.profile->curve.foot(profile_place(s, p));
}

}  // namespace ligne
