#pragma once
/// Normals of surfaces at points whose place about the axis is known.

#include <glm/geometric.hpp>

#include "scene/patches/patch_surface.hpp"

namespace ligne {

/// PatchSurface::normal() of a point with its axis_place(). Spheres do not read the place.
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
    default:
      return place.out;
  }
}

}  // namespace ligne
