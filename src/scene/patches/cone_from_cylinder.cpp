#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/small_matrices.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {
namespace {

// Adjustable. Steps at most, and attempts at one step, each of which multiplies the damping by kDampingFactor.
constexpr int kMostConeSteps = 8, kMostConeAttempts = 3;
constexpr double kDampingFactor = 10, kDampingBegin = 1e-4;
/// A step that leaves more than this fraction of the sum of squares is the last one.
constexpr double kConeSettled = 0.7;
/// Largest angle between the axis and the rulings, in radians: 80 degrees.
constexpr double kLargestConeAngle = 80 * std::numbers::pi / 180;

/// A cone by one of its points, the normal and the ruling there, the radius of its curvature across that, and the angle
/// between ruling and axis, positive where the cone widens along the ruling.
struct TouchedCone {
  Point3 at, normal, ruling;
  double radius = 0, angle = 0;

  PatchSurface surface() const {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    PatchSurface s{.kind = SurfaceKind::cone, .axis = cosine * ruling - sine * normal};
    s.radius = radius * cosine;  // Meusnier's theorem
    s.slope = std::tan(angle);
    s.at = at - s.radius * (sine * ruling + cosine * normal);
    return s;
  }
};

class TouchedConeFit {
 public:
  TouchedConeFit(const TouchedCone& cone, std::span<const Point3> points) : cone_(cone), points_(points) {}

  PatchSurface run() {
    sum_ = squares(cone_.surface());
    for (int step = 0; step < kMostConeSteps && take_step(); ++step) {
    }
    return cone_.surface();
  }

 private:
  static constexpr std::size_t kCount = 6;
  using Row = std::array<double, kCount>;

  double squares(const PatchSurface& s) const {
    double sum = 0;
    for (const Point3& p : points_) {
      const double distance = s.distance(p);
      sum += distance * distance;
    }
    return sum;
  }

  /// Derivatives of the signed distance of a point: with respect to a shift along the normal, turns about the ruling, the
  /// direction across and the normal, the radius and the angle.
  Row derivatives(const PatchSurface& s, const Point3& p) const {
    const double cosine = std::cos(cone_.angle), sine = std::sin(cone_.angle);
    const Point3 normal = s.normal(p), way = p - cone_.at;
    // A turn w moves the point by w x way, which changes the distance by -normal . (w x way).
    const Point3 turn = glm::cross(normal, way);
    const Point3 across = glm::cross(cone_.ruling, cone_.normal), out = sine * cone_.ruling + cosine * cone_.normal;
    const double beside = glm::dot(normal, out) - cosine, along = glm::dot(p - s.at, s.axis), distance = s.distance(p);
    return {-glm::dot(normal, cone_.normal),
            glm::dot(turn, cone_.ruling),
            glm::dot(turn, across),
            glm::dot(turn, cone_.normal),
            cosine * beside,
            glm::dot(turn, glm::cross(out, s.axis)) - cone_.radius * sine * beside - along / cosine - distance * s.slope};
  }

  TouchedCone moved(const Row& by) const {
    TouchedCone next = cone_;
    const Point3 across = glm::cross(cone_.ruling, cone_.normal);
    const Point3 turn = by[1] * cone_.ruling + by[2] * across + by[3] * cone_.normal;
    next.at += by[0] * cone_.normal;
    next.normal = glm::normalize(cone_.normal + glm::cross(turn, cone_.normal));
    const Point3 ruling = cone_.ruling + glm::cross(turn, cone_.ruling);
    next.ruling = glm::normalize(ruling - glm::dot(ruling, next.normal) * next.normal);
    next.radius += by[4];
    next.angle += by[5];
    return next;
  }

  /// Returns whether another step may improve the cone much.
  bool take_step() {
    const PatchSurface here = cone_.surface();
    std::array<Row, kCount> normal{};
    Row right{};
    for (const Point3& p : points_) {
      const Row row = derivatives(here, p);
      const double distance = here.distance(p);
      for (std::size_t i = 0; i < kCount; ++i) {
        right[i] -= row[i] * distance;
        for (std::size_t j = 0; j <= i; ++j) normal[i][j] += row[i] * row[j];
      }
    }
    for (int attempt = 0; attempt < kMostConeAttempts; ++attempt, damping_ *= kDampingFactor) {
      std::array<Row, kCount> damped = normal;
      for (std::size_t i = 0; i < kCount; ++i) damped[i][i] *= 1 + damping_;
      Row by = right;
      if (!solve_symmetric(damped, by)) continue;
      const TouchedCone next = moved(by);
      if (!(next.radius > 0) || !(std::abs(next.angle) < kLargestConeAngle)) continue;
      const double sum = squares(next.surface());
      if (!(sum < sum_)) continue;
      const bool is_settled = sum > kConeSettled * sum_;
      cone_ = next;
      sum_ = sum;
      damping_ /= kDampingFactor;
      return !is_settled;
    }
    return false;
  }

  TouchedCone cone_;
  std::span<const Point3> points_;
  double sum_ = 0, damping_ = kDampingBegin;
};

}  // namespace

PatchSurface cone_from_cylinder(const PatchSurface& cylinder, std::span<const Point3> points) {
  Point3 middle(0, 0, 0);
  for (const Point3& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  const TouchedCone start{cylinder.nearest(middle), cylinder.normal(middle), cylinder.axis, cylinder.radius};
  return TouchedConeFit(start, points).run();
}

}  // namespace ligne
