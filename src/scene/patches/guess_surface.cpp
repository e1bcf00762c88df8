#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "geometry/small_matrices.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {
namespace {

/// Least ratio of two eigenvalues that distinguishes directions: normals that turn by less than about 2 milliradians
/// determine no axis.
constexpr double kFlatTurn = 1e-6;
/// Least square of the cosine between the normals of a cone and the plane across its axis. The tangent of the angle is
/// then a million at most. Such a cone is a plane, and is_plausible() rejects its slope.
constexpr double kLeastSquaredCosine = 1e-12;

struct PageCircle {
  Point2 centre;
  double radius;
};

/// The circle x^2 + y^2 = 2 a x + 2 b y + c of the least sum of squared differences [Kasa1976].
std::optional<PageCircle> kasa_circle(std::span<const Point2> points) {
  Point2 middle(0, 0);
  for (const Point2& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  Matrix3 m{};
  Point3 right(0, 0, 0);
  for (const Point2& p : points) {
    const Point2 q = p - middle;
    const Point3 row(2 * q.x, 2 * q.y, 1);
    add_product(m, row, row);
    right += row * (q.x * q.x + q.y * q.y);
  }
  const auto x = solve(m, right);
  if (!x) return std::nullopt;
  const double square = x->z + x->x * x->x + x->y * x->y;
  if (!(square > 0)) return std::nullopt;
  return PageCircle{Point2(x->x, x->y) + middle, std::sqrt(square)};
}

bool guess_cylinder(const SurfaceSample& sample, PatchSurface& s) {
  const Eigen3 e = symmetric_eigen(sample.squares);
  if (!(e.values[1] > kFlatTurn * e.values[2])) return false;
  s.axis = e.vectors[0];
  const auto [u, v] = frame_of(s.axis);
  std::vector<Point2> section;
  section.reserve(sample.points.size());
  for (const Point3& p : sample.points) {
    const Point3 way = p - sample.middle;
    section.emplace_back(glm::dot(way, u), glm::dot(way, v));
  }
  const auto circle = kasa_circle(section);
  if (!circle) return false;
  s.at = sample.middle + circle->centre.x * u + circle->centre.y * v;
  s.radius = circle->radius;
  return true;
}

bool guess_cone(const SurfaceSample& sample, PatchSurface& s) {
  Point3 mean(0, 0, 0);
  for (const FacetFrame& f : sample.frames) mean += f.normal;
  mean /= static_cast<double>(sample.frames.size());
  Matrix3 spread{};
  Point3 right(0, 0, 0);
  for (const FacetFrame& f : sample.frames) {
    add_product(spread, f.normal - mean, f.normal - mean);
    right += f.normal * glm::dot(f.normal, f.middle - sample.middle);
  }
  const Eigen3 e = symmetric_eigen(spread);
  if (!(e.values[1] > kFlatTurn * kFlatTurn)) return false;
  s.axis = e.vectors[0];
  const auto apex = solve(sample.squares, right);
  if (!apex) return false;
  // Rulings are perpendicular to the normals, so the slope is the tangent of the normals' angle to the plane across the
  // axis.
  const double sine = glm::dot(mean, s.axis) / glm::length(mean);
  const double tangent = std::abs(sine) / std::sqrt(std::max(kLeastSquaredCosine, 1 - sine * sine));
  const double along = -glm::dot(*apex, s.axis);
  s.at = sample.middle + *apex + along * s.axis;
  s.slope = along < 0 ? -tangent : tangent;
  s.radius = std::abs(along) * tangent;
  return s.radius > 0;
}

bool guess_sphere(const SurfaceSample& sample, PatchSurface& s) {
  double mean_square = 0;
  for (const Point3& p : sample.points) mean_square += glm::dot(p - sample.middle, p - sample.middle);
  mean_square /= static_cast<double>(sample.points.size());
  Matrix3 m{};
  Point3 right(0, 0, 0);
  for (const Point3& p : sample.points) {
    const Point3 q = 2.0 * (p - sample.middle);
    add_product(m, q, q);
    right += q * (glm::dot(q, q) / 4 - mean_square);
  }
  const auto centre = solve(m, right);
  if (!centre) return false;
  s.at = sample.middle + *centre;
  s.radius = std::sqrt(mean_square + glm::dot(*centre, *centre));
  return true;
}

/// The line c, c' (direction and moment) with the least sum of (c' . n + c . (p x n))^2 over the normals n at p.
bool guess_axis(const SurfaceSample& sample, PatchSurface& s) {
  Matrix3 mixed{}, moments{};
  for (const FacetFrame& f : sample.frames) {
    const Point3 moment = glm::cross(f.middle - sample.middle, f.normal);
    add_product(mixed, f.normal, moment);
    add_product(moments, moment, moment);
  }
  // For a given c the best c' is -normals^-1 mixed c, which leaves a quadratic form in c.
  std::array<Point3, 3> columns;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto column = solve(sample.squares, Point3(mixed[0][j], mixed[1][j], mixed[2][j]));
    if (!column) return false;
    columns[j] = *column;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) moments[i][j] -= mixed[k][i] * columns[j][static_cast<int>(k)];
    }
  }
  const Point3 c = symmetric_eigen(moments).vectors[0];
  s.axis = c;
  s.at = sample.middle + glm::cross(c, -(columns[0] * c.x + columns[1] * c.y + columns[2] * c.z));
  return true;
}

/// Completes a torus whose axis is known.
bool guess_profile(std::span<const Point3> points, PatchSurface& s) {
  std::vector<Point2> profile;
  profile.reserve(points.size());
  for (const Point3& p : points) {
    const AxisPlace place = axis_place(s, p);
    profile.emplace_back(place.radius, place.along);
  }
  const auto circle = kasa_circle(profile);
  if (!circle) return false;
  s.radius = circle->centre.x;
  s.at += circle->centre.y * s.axis;
  s.tube = circle->radius;
  return s.radius > 0;
}

bool guess_torus(const SurfaceSample& sample, PatchSurface& s) {
  return guess_axis(sample, s) && guess_profile(sample.points, s);
}

}  // namespace

bool guess_torus_about(const PatchSurface& round, std::span<const Point3> points, PatchSurface& torus) {
  torus = PatchSurface{};
  torus.kind = SurfaceKind::torus;
  torus.axis = round.axis;
  torus.at = round.at;
  return guess_profile(points, torus);
}

bool guess_surface(SurfaceKind kind, const SurfaceSample& sample, PatchSurface& surface) {
  surface = PatchSurface{};
  surface.kind = kind;
  switch (kind) {
    case SurfaceKind::cylinder:
      return sample.frames.size() >= 2 && guess_cylinder(sample, surface);
    case SurfaceKind::cone:
      return sample.frames.size() >= 3 && guess_cone(sample, surface);
    case SurfaceKind::sphere:
      return sample.points.size() >= 5 && guess_sphere(sample, surface);
    case SurfaceKind::torus:
      return sample.frames.size() >= 5 && guess_torus(sample, surface);
    case SurfaceKind::extruded:
    case SurfaceKind::revolved:
      break;
  }
  return false;
}

}  // namespace ligne
