#pragma once
/// The profile of an extruded or a revolved surface.

#include <glm/geometric.hpp>

#include "scene/patches/patch_surface.hpp"
#include "scene/patches/swept/profile_curve.hpp"

namespace ligne {

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
