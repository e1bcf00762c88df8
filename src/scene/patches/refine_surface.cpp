#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "base/uninitialized_vector.hpp"
#include "geometry/small_matrices.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {
namespace {

constexpr int kMostSteps = 12;    ///< Newton steps at most; fits that succeed take three to six
constexpr int kMostAttempts = 3;  ///< attempts at one step; each multiplies the damping by kDampingStep
constexpr double kDampingStep = 10;
/// Adjustable. Damping as a fraction of the diagonal: first, least, and least after a failed attempt. Rounding errors
/// of sums over a hundred corners are a hundredth of the least damping, so less has little effect.
constexpr double kFirstDamping = 1e-6, kLeastDamping = 1e-12, kFailedDamping = 1e-9;
/// Adjustable. A fit is given up before a step that would leave more than this fraction of the sum of squares, and more than
/// that of hopeless distances.
constexpr double kVain = 0.7;
constexpr double kSettled = 0.5;  ///< a step that leaves more than this fraction of the sum of squares is the last one

/// A point in the frame of a surface: (x, y, axis) of frame_of(), from PatchSurface::at.
struct PlacedPoint {
  double x, y, along;
  double radius;    ///< from the axis; of a sphere: from the centre
  double distance;  ///< from the surface, with its sign
};

/// The fit of a surface of one kind.
template <SurfaceKind kKind>
class SurfaceFit {
 public:
  SurfaceFit(PatchSurface& surface, std::span<const Point3> points, double hopeless)
      : surface_(surface),
        points_(points),
        memory_(2 * points.size()),
        placed_(memory_.data(), points.size()),
        next_placed_(memory_.data() + points.size(), points.size()),
        most_sum_(static_cast<double>(points.size()) * hopeless * hopeless) {}

  /// Returns the largest remaining distance.
  double run() {
    // Each point is placed once for each surface: its place beside the best one so far serves the next step too.
    frame_ = frame_of(surface_.axis);
    sum_ = place(surface_, frame_, placed_);
    for (int step = 0; step < kMostSteps && take_step(); ++step) {
    }
    double most = 0;
    for (const PlacedPoint& p : placed_) most = std::max(most, std::abs(p.distance));
    return most;
  }

 private:
  static constexpr std::size_t kCount = parameter_count(kKind);
  using Row = std::array<double, kCount>;
  using Matrix = std::array<Row, kCount>;
  using Frame = std::array<Point3, 2>;

  /// Sets `placed` to the places of the points beside a surface. Returns the sum of their squared distances.
  double place(const PatchSurface& s, const Frame& frame, std::span<PlacedPoint> placed) const {
    const double cosine = 1 / std::sqrt(1 + s.slope * s.slope);
    double sum = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const Point3 way = points_[k] - s.at;
      PlacedPoint& p = placed[k];
      p.x = glm::dot(way, frame[0]), p.y = glm::dot(way, frame[1]), p.along = glm::dot(way, s.axis);
      const double square = p.x * p.x + p.y * p.y;
      p.radius = std::sqrt(kKind == SurfaceKind::sphere ? square + p.along * p.along : square);
      p.distance = p.radius - s.radius;
      if constexpr (kKind == SurfaceKind::cone) p.distance = (p.distance - s.slope * p.along) * cosine;
      if constexpr (kKind == SurfaceKind::torus) {
        p.distance = std::sqrt(p.distance * p.distance + p.along * p.along) - s.tube;
      }
      sum += p.distance * p.distance;
    }
    return sum;
  }

  /// Derivatives of the signed distance of a point with respect to each parameter. A motion of the surface changes it by
  /// -n . (motion of the point), where n is the normal; a turn of the axis towards x moves the point by (along, 0, -x).
  Row derivatives(const PlacedPoint& p) const {
    const bool is_off_axis = p.radius > 0;
    if constexpr (kKind == SurfaceKind::sphere) {
      return is_off_axis ? Row{-p.x / p.radius, -p.y / p.radius, -p.along / p.radius, -1} : Row{0, 0, -1, -1};
    } else {
      const double x = is_off_axis ? p.x / p.radius : 1, y = is_off_axis ? p.y / p.radius : 0;
      if constexpr (kKind == SurfaceKind::cylinder) return {-x, -y, -x * p.along, -y * p.along, -1};
      if constexpr (kKind == SurfaceKind::cone) {
        const double cosine = 1 / std::sqrt(1 + surface_.slope * surface_.slope), na = -surface_.slope * cosine;
        const double nx = cosine * x, ny = cosine * y;
        return {-nx,
                -ny,
                na * p.x - nx * p.along,
                na * p.y - ny * p.along,
                -cosine,
                -cosine * p.along - p.distance * surface_.slope * cosine * cosine};
      }
      if constexpr (kKind == SurfaceKind::torus) {
        const double length = p.distance + surface_.tube, out = length > 0 ? (p.radius - surface_.radius) / length : 0;
        const double nx = out * x, ny = out * y, na = length > 0 ? p.along / length : 1;
        return {-nx, -ny, -na, na * p.x - nx * p.along, na * p.y - ny * p.along, -out, -1};
      }
    }
  }

  static PatchSurface moved(PatchSurface s, const Row& by, const Frame& frame) {
    const auto& [u, v] = frame;
    constexpr bool kMovesAlong = kKind == SurfaceKind::sphere || kKind == SurfaceKind::torus;
    s.at += by[0] * u + by[1] * v;
    if constexpr (kMovesAlong) s.at += by[2] * s.axis;
    if constexpr (kKind == SurfaceKind::sphere) {
      s.radius += by[3];
    } else {
      constexpr std::size_t k = kMovesAlong ? 3 : 2;
      s.axis = glm::normalize(s.axis + by[k] * u + by[k + 1] * v);
      s.radius += by[k + 2];
      if constexpr (kKind == SurfaceKind::cone) s.slope += by[5];
      if constexpr (kKind == SurfaceKind::torus) s.tube += by[6];
    }
    return s;
  }

  /// Returns whether another step may improve the surface much.
  bool take_step() {
    Matrix normal{};
    Row right{};
    for (const PlacedPoint& p : placed_) {
      const Row row = derivatives(p);
      for (std::size_t i = 0; i < kCount; ++i) {
        right[i] -= row[i] * p.distance;
        for (std::size_t j = 0; j <= i; ++j) normal[i][j] += row[i] * row[j];
      }
    }
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
      Matrix damped = normal;
      for (std::size_t i = 0; i < kCount; ++i) damped[i][i] *= 1 + damping_;
      Row by = right;
      if (solve_symmetric(damped, by)) {
        double left = sum_;  // what the step leaves of the sum, were the distances linear
        for (std::size_t i = 0; i < kCount; ++i) left -= right[i] * by[i];
        if (left > most_sum_ && left > kVain * sum_) return false;
        const PatchSurface next = moved(surface_, by, frame_);
        const Frame next_frame = frame_of(next.axis);
        const double next_sum = place(next, next_frame, next_placed_);
        if (next_sum < sum_) {
          const bool is_settled = next_sum > kSettled * sum_;
          surface_ = next;
          frame_ = next_frame;
          std::swap(placed_, next_placed_);
          sum_ = next_sum;
          damping_ = std::max(kLeastDamping, damping_ / kDampingStep);
          return !is_settled;
        }
      }
      damping_ = std::max(kFailedDamping, damping_ * kDampingStep);
    }
    return false;
  }

  PatchSurface& surface_;
  std::span<const Point3> points_;
  Frame frame_{};
  UninitializedVector<PlacedPoint> memory_;
  std::span<PlacedPoint> placed_, next_placed_;
  double most_sum_;  ///< sum of squares of hopeless distances
  double sum_ = 0, damping_ = kFirstDamping;
};

}  // namespace

double refine_surface(PatchSurface& surface, std::span<const Point3> points, double hopeless) {
  switch (surface.kind) {
    case SurfaceKind::cylinder:
      return SurfaceFit<SurfaceKind::cylinder>(surface, points, hopeless).run();
    case SurfaceKind::cone:
      return SurfaceFit<SurfaceKind::cone>(surface, points, hopeless).run();
    case SurfaceKind::sphere:
      return SurfaceFit<SurfaceKind::sphere>(surface, points, hopeless).run();
    case SurfaceKind::torus:
      return SurfaceFit<SurfaceKind::torus>(surface, points, hopeless).run();
    case SurfaceKind::extruded:
    case SurfaceKind::revolved:
      break;
  }
  return 0;
}

}  // namespace ligne
