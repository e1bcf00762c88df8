#include "scene/patches/refine/shared_point.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ligne {
namespace {

/// Least cosine between the normals of two surfaces that join smoothly (10 degrees).
constexpr double kTangentCosine = 0.985;
/// Largest number of steps of Newton's method: it doubles the digits at each.
constexpr int kSteps = 12;
/// Largest distance of a shared point from either surface, as a fraction of its distance from the middle of the edge, and
/// in lengths of the edge. Surfaces that were fitted one by one touch only nearly.
constexpr double kNearer = 0.1, kAccuracy = 1e-4;
/// Largest distance of a shared point from the middle of the edge, in lengths of the edge: that of a half circle.
constexpr double kFarthest = 0.5;
/// A point nearer to the axis than this, in distances of the other end, is an apex: its direction from the axis is rounding.
constexpr double kApexPart = 1e-3;

/// Normals that differ by a smaller sine are one: the direction of their difference is rounding.
constexpr double kSameSine = 1e-7;

double curvature(const SideSurface& side, const Point3& p, const Point3& along) {
  return side.surface ? side.surface->curvature(p, along) : 0;
}

Point3 nearest(const SideSurface& side, const Point3& p) { return p - side.distance(p) * side.normal_at(p); }

/// The point of a surface halfway between two of its points, along its profile and about its axis. The point nearest to the
/// middle of a long chord of a thin torus lies elsewhere.
Point3 halfway(const PatchSurface& surface, const Point3& p, const Point3& q) {
  const Point3 middle = 0.5 * (p + q);
  const AxisPlace a = axis_place(surface, p), b = axis_place(surface, q);
  const Point3 out = a.radius < kApexPart * b.radius ? b.out : b.radius < kApexPart * a.radius ? a.out : a.out + b.out;
  const double length = glm::length(out);
  const bool has_no_circles = surface.kind == SurfaceKind::sphere || surface.kind == SurfaceKind::extruded;
  if (has_no_circles || !(length > 0)) return surface.nearest(middle);
  double along = 0.5 * (a.along + b.along), radius = 0.5 * (a.radius + b.radius);
  if (surface.kind == SurfaceKind::torus) {
    const double from = std::atan2(a.along, a.radius - surface.radius), to = std::atan2(b.along, b.radius - surface.radius);
    const double angle = from + 0.5 * std::remainder(to - from, 2 * std::numbers::pi);
    along = surface.tube * std::sin(angle);
    radius = surface.radius + surface.tube * std::cos(angle);
  }
  return surface.nearest(surface.at + along * surface.axis + radius / length * out);
}

bool are_tangent(const SideSurface& a, const SideSurface& b, const Point3& p) {
  return std::abs(glm::dot(a.normal_at(p), b.normal_at(p))) >= kTangentCosine;
}

/// One step towards the intersection of both surfaces.
Point3 step_to_both(const SideSurface& a, const SideSurface& b, const Point3& p) {
  const Point3 na = a.normal_at(p), nb = b.normal_at(p);
  const double da = a.distance(p), db = b.distance(p), c = glm::dot(na, nb), s = 1 - c * c;
  if (!(s > 0)) return p;
  return p - (da - c * db) / s * na - (db - c * da) / s * nb;
}

/// One step towards the line along which both surfaces have one normal. p lies on b. The angle between the normals
/// grows across that line with the difference of the curvatures.
Point3 step_to_contact(const SideSurface& a, const SideSurface& b, const Point3& p) {
  const Point3 n = b.normal_at(p);
  Point3 na = a.normal_at(p);
  const double sign = glm::dot(na, n) < 0 ? -1 : 1;
  na *= sign;
  const double c = glm::dot(na, n);
  const Point3 apart = na - c * n;
  const double sine = glm::length(apart);
  if (sine <= kSameSine || !(c > 0)) return p;
  const Point3 across = apart / sine;
  const double bend = sign * curvature(a, p, across) - curvature(b, p, across);
  if (bend == 0) return p;
  return nearest(b, p - sine / c / bend * across);
}

}  // namespace

double SideSurface::distance(const Point3& p) const { return surface ? surface->distance(p) : glm::dot(p - at, normal); }

Point3 SideSurface::normal_at(const Point3& p) const { return surface ? surface->normal(p) : normal; }

std::optional<Point3> shared_point(const SideSurface& a, const SideSurface& b, const Point3& p, const Point3& q) {
  const Point3 middle = 0.5 * (p + q);
  const double length = glm::distance(p, q);
  const bool touches = are_tangent(a, b, p) && are_tangent(a, b, q);
  // The steps between touching surfaces stay on the second one, which is the plane if there is one.
  const SideSurface &first = a.surface ? a : b, &second = a.surface ? b : a;
  Point3 at = halfway(*first.surface, p, q);
  if (a.surface != b.surface) {
    if (touches) at = nearest(second, at);
    for (int step = 0; step < kSteps; ++step) {
      at = touches ? step_to_contact(first, second, at) : step_to_both(first, second, at);
      if (!(glm::distance(at, middle) <= 2 * kFarthest * length)) return std::nullopt;
    }
    if (!second.surface) at = nearest(second, at);
  }
  const double off = std::max(std::abs(a.distance(at)), std::abs(b.distance(at)));
  const double shift = glm::distance(at, middle);
  if (!(off <= kNearer * shift + kAccuracy * length) || !(shift <= kFarthest * length)) return std::nullopt;
  return at;
}

}  // namespace ligne
