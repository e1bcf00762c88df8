#pragma once
/// Normals of surfaces at points whose AxisPlace is known already.

#include <glm/geometric.hpp>

#include "scene/patches/patch_surface.hpp"
#include "scene/patches/swept/swept_profile.hpp"

namespace ligne {

/// PatchSurface::normal(p), but with `place` given, which must be axis_place(s, p). Spheres do not
/// read `place`.
inline Point3 normal_at(const PatchSurface& s, const Point3& p, const AxisPlace& place) {
  const auto unit = [&](const Point3& way) {
    const double length = glm::length(way);
    return length > 0 ? way / length : s.axis;
  };
  switch (s.kind) {
    case SurfaceKind::sphere:
      return unit(p - s.at);
    case SurfaceKind::cone:
      return unit(place.out - s.slope * s.axis);
    case SurfaceKind::torus:
      return unit((place.radius - s.radius) * place.out + place.along * s.axis);
    case SurfaceKind::extruded: {
      const Point2 normal = swept_foot(s, p).normal;
      return normal.x * s.profile->x + normal.y * s.profile->y;
    }
    case SurfaceKind::revolved: {
      const Point2 normal = s.profile->curve.foot({place.radius, place.along}).normal;
      return normal.x * place.out + normal.y * s.axis;
    }
    default:
      return place.out;
  }
}

}  // namespace ligne
