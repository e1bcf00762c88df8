#include "scene/patches/patch_surface.hpp"

#include <algorithm>

#include "scene/patches/swept/profile_curve.hpp"

namespace ligne {
namespace {

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

/// Adjustable. For adjacent pieces of a bent tube: largest relative difference of their radii, and least and largest sine
/// of the angle between their axes.
constexpr double kTubePart = 0.1, kLeastPieceSine = 0.02, kMostPieceSine = 0.52;

}  // namespace

std::array<Point3, 2> frame_of(const Point3& axis) {
  const Point3 other = std::abs(axis.x) < 0.6 ? Point3(1, 0, 0) : Point3(0, 1, 0);
  const Point3 u = glm::normalize(glm::cross(axis, other));
  return {u, glm::cross(axis, u)};
}

AxisPlace axis_place(const PatchSurface& surface, const Point3& p) {
  const Point3 way = p - surface.at;
  AxisPlace place;
  place.along = glm::dot(way, surface.axis);
  const Point3 away = way - place.along * surface.axis;
  place.radius = glm::length(away);
  place.out = place.radius > 0 ? away / place.radius : frame_of(surface.axis)[0];
  return place;
}

double PatchSurface::distance_from_profile(const Point3& p) const { return swept_foot(*this, p).distance; }

Point3 PatchSurface::normal(const Point3& p) const {
  return normal_at(*this, p, kind == SurfaceKind::sphere ? AxisPlace{} : axis_place(*this, p));
}

namespace {

/// Least distance from the axis for which the curvature around the axis is computed, since it is unbounded on the axis
/// itself. That curvature times any length of a model is still a finite number.
constexpr double kLeastRadius = 1e-300;

/// Principal curvatures: round the axis, and along the profile.
struct Principal {
  double around = 0, along = 0;
};

Principal principal_curvatures(const PatchSurface& s, const AxisPlace& place) {
  const double radius = std::max(place.radius, kLeastRadius);
  switch (s.kind) {
    case SurfaceKind::cylinder:
      return {1 / s.radius, 0};
    case SurfaceKind::cone:
      return {1 / (radius * std::sqrt(1 + s.slope * s.slope)), 0};
    case SurfaceKind::sphere:
      return {1 / s.radius, 1 / s.radius};
    case SurfaceKind::torus:
      return {(place.radius - s.radius) / (s.tube * radius), 1 / s.tube};
    case SurfaceKind::revolved: {
      const ProfileCurve::Foot foot = s.profile->curve.foot({place.radius, place.along});
      return {foot.normal.x / radius, foot.curvature};
    }
    case SurfaceKind::extruded:
      return {};
  }
  return {};
}

}  // namespace

bool are_tube_pieces(const PatchSurface& s, const PatchSurface& other) {
  if (s.kind != SurfaceKind::cylinder || other.kind != SurfaceKind::cylinder) return false;
  if (std::abs(s.radius - other.radius) > kTubePart * s.radius) return false;
  const double sine = glm::length(glm::cross(s.axis, other.axis));
  return sine >= kLeastPieceSine && sine <= kMostPieceSine;
}

double PatchSurface::curvature(const Point3& p, const Point3& along) const {
  if (kind == SurfaceKind::extruded) {
    const double lengthwise = glm::dot(along, axis);
    return (1 - lengthwise * lengthwise) * swept_foot(*this, p).curvature;
  }
  const AxisPlace place = axis_place(*this, p);
  const Principal k = principal_curvatures(*this, place);
  const double around = glm::dot(along, glm::cross(axis, place.out));
  return around * around * k.around + (1 - around * around) * k.along;
}

double PatchSurface::largest_curvature(const Point3& p) const {
  if (kind == SurfaceKind::extruded) return std::abs(swept_foot(*this, p).curvature);
  const Principal k = principal_curvatures(*this, axis_place(*this, p));
  return std::max(std::abs(k.around), std::abs(k.along));
}

}  // namespace ligne
