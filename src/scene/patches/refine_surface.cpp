#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "geometry/small_matrices.hpp"
#include "scene/patches/normal_at.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {
namespace {

constexpr int kMostSteps = 12;    ///< Newton steps at most; fits that succeed take three to six
constexpr int kMostAttempts = 3;  ///< attempts at one step; each multiplies the damping by kDampingStep
constexpr double kDampingStep = 10;
/// Adjustable. Damping as a fraction of the diagonal: first, least, and least after a failed attempt. Rounding errors
/// of sums over a hundred corners are a hundredth of the least damping, so less has little effect.
constexpr double kFirstDamping = 1e-6, kLeastDamping = 1e-12, kFailedDamping = 1e-9;
constexpr double kSettled = 0.5;  ///< a step that leaves more than this fraction of the sum of squares is the last one

/// Derivatives of the signed distance of p with respect to each parameter. A motion of the surface changes it by -n .
/// (motion of p).
ParameterRow derivatives(const PatchSurface& s, const Point3& p, const std::array<Point3, 2>& frame) {
  const AxisPlace place = s.kind == SurfaceKind::sphere ? AxisPlace{} : axis_place(s, p);
  const Point3 n = normal_at(s, p, place);
  const auto& [u, v] = frame;
  const auto shift = [&](const Point3& by) { return -glm::dot(n, by); };
  const auto turn = [&](const Point3& towards) { return -glm::dot(n, glm::cross(glm::cross(s.axis, towards), p - s.at)); };
  switch (s.kind) {
    case SurfaceKind::cylinder:
      return {shift(u), shift(v), turn(u), turn(v), -1};
    case SurfaceKind::cone: {
      const double cosine = 1 / std::sqrt(1 + s.slope * s.slope);
      const double off = (place.radius - s.radius - s.slope * place.along) * cosine;
      return {shift(u), shift(v), turn(u), turn(v), -cosine, -place.along * cosine - off * s.slope * cosine * cosine};
    }
    case SurfaceKind::sphere:
      return {shift(u), shift(v), shift(s.axis), -1};
    case SurfaceKind::torus:
      return {shift(u), shift(v), shift(s.axis), turn(u), turn(v), -glm::dot(n, place.out), -1};
  }
  return {};
}

PatchSurface moved(PatchSurface s, const ParameterRow& by, const std::array<Point3, 2>& frame) {
  const auto& [u, v] = frame;
  const bool moves_along = s.kind == SurfaceKind::sphere || s.kind == SurfaceKind::torus;
  s.at += by[0] * u + by[1] * v;
  if (moves_along) s.at += by[2] * s.axis;
  if (s.kind == SurfaceKind::sphere) {
    s.radius += by[3];
    return s;
  }
  const std::size_t k = moves_along ? 3 : 2;
  s.axis = glm::normalize(s.axis + by[k] * u + by[k + 1] * v);
  s.radius += by[k + 2];
  if (s.kind == SurfaceKind::cone) s.slope += by[5];
  if (s.kind == SurfaceKind::torus) s.tube += by[6];
  return s;
}

/// Sets `distances` to the distances of the points from the surface. Returns the sum of their squares.
double measure(const PatchSurface& s, std::span<const Point3> points, std::vector<double>& distances) {
  distances.clear();
  double sum = 0;
  for (const Point3& p : points) {
    const double off = s.distance(p);
    sum += off * off;
    distances.push_back(off);
  }
  return sum;
}

}  // namespace

double refine_surface(PatchSurface& surface, std::span<const Point3> points) {
  const std::size_t n = parameter_count(surface.kind);
  // Each point is measured once for each surface: the distances from the best one so far serve the next step too.
  std::vector<double> distances, next_distances;
  distances.reserve(points.size());
  next_distances.reserve(points.size());
  double sum = measure(surface, points, distances), damping = kFirstDamping;
  bool settled = false;
  for (int step = 0; step < kMostSteps && !settled; ++step) {
    const auto frame = frame_of(surface.axis);
    ParameterMatrix normal{};
    ParameterRow right{};
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double off = distances[k];
      const ParameterRow row = derivatives(surface, points[k], frame);
      for (std::size_t i = 0; i < n; ++i) {
        right[i] -= row[i] * off;
        for (std::size_t j = 0; j <= i; ++j) normal[i][j] += row[i] * row[j];
      }
    }
    settled = true;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
      ParameterMatrix damped = normal;
      for (std::size_t i = 0; i < n; ++i) damped[i][i] *= 1 + damping;
      ParameterRow by{};
      if (solve_symmetric(damped, right, n, by)) {
        const PatchSurface next = moved(surface, by, frame);
        const double next_sum = measure(next, points, next_distances);
        if (next_sum < sum) {
          settled = next_sum > kSettled * sum;
          surface = next;
          distances.swap(next_distances);
          sum = next_sum;
          damping = std::max(kLeastDamping, damping / kDampingStep);
          break;
        }
      }
      damping = std::max(kFailedDamping, damping * kDampingStep);
    }
  }
  double most = 0;
  for (const double off : distances) most = std::max(most, std::abs(off));
  return most;
}

}  // namespace ligne
