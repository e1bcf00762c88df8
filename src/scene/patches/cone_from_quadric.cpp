#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "geometry/small_matrices.hpp"
#include "scene/patches/patch_surface.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Weight of the normals against the points. It is small, since the points lie on the surface: it decides only among the
/// quadrics through all of them, which are many if they lie on two circles.
constexpr double kNormalWeight = 1e-5;
/// Least weight of a coefficient, as a fraction of the largest sum of squares.
constexpr double kLeastWeight = 1e-13;
/// Steps of the inverse iteration.
constexpr int kSteps = 3;
/// Largest root of the mean square of the points' distances from the quadric nearest to them, as a fraction of that of the
/// facets. It is more than the largest distance of a point from a surface, as a fraction of the sag.
constexpr double kMostPart = 0.05;

constexpr std::size_t kCount = 10;
using Row = std::array<double, kCount>;
using Matrix = std::array<Row, kCount>;

/// The terms of a quadric at p.
Row terms(const Point3& p) { return {p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.x * p.z, p.y * p.z, p.x, p.y, p.z, 1}; }

/// The derivatives of the terms at p along d.
Row slopes(const Point3& p, const Point3& d) {
  return {2 * p.x * d.x,
          2 * p.y * d.y,
          2 * p.z * d.z,
          p.x * d.y + p.y * d.x,
          p.x * d.z + p.z * d.x,
          p.y * d.z + p.z * d.y,
          d.x,
          d.y,
          d.z,
          0};
}

double product(const Row& a, const Row& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kCount; ++i) sum += a[i] * b[i];
  return sum;
}

/// Adds the outer product of a row with itself to the lower triangle.
void add_square(Matrix& m, const Row& row, double weight = 1) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const double scaled = weight * row[i];
    for (std::size_t j = 0; j <= i; ++j) m[i][j] += scaled * row[j];
  }
}

/// Sums of the products of (x, y, z, 1) at several points.
using Moments = std::array<std::array<double, 4>, 4>;

/// Adds the outer products of the derivatives along the three axes to the lower triangle. These are linear at each point.
void add_gradient_squares(Matrix& m, const Moments& moments, double weight) {
  constexpr std::array<std::array<std::size_t, 4>, 3> kTerms{{{0, 3, 4, 6}, {1, 3, 5, 7}, {2, 4, 5, 8}}};
  constexpr std::array<std::array<std::size_t, 4>, 3> kPlaces{{{0, 1, 2, 3}, {1, 0, 2, 3}, {2, 0, 1, 3}}};
  constexpr std::array<double, 4> kFactors{2, 1, 1, 1};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        m[kTerms[axis][i]][kTerms[axis][j]] +=
            weight * kFactors[i] * kFactors[j] * moments[kPlaces[axis][i]][kPlaces[axis][j]];
      }
    }
  }
}

/// The quadrics near the points of a sample, in units of its size about its middle.
class QuadricFit {
 public:
  explicit QuadricFit(const SurfaceSample& sample) : sample_(sample) {
    double square = 0;
    for (const Point3& p : sample.points) square = std::max(square, glm::dot(p - sample.middle, p - sample.middle));
    size_ = std::sqrt(square);
    for (const Point3& p : sample.points) add_square(squares_, terms(placed(p)));
    double most = 0;
    for (std::size_t i = 0; i < kCount; ++i) most = std::max(most, squares_[i][i]);
    for (std::size_t i = 0; i < kCount; ++i) squares_[i][i] += kLeastWeight * most;
  }

  double size() const { return size_; }

  /// Whether a quadric passes by all points, in comparison with the middles of the facets.
  bool has_quadric() const {
    if (!(size_ > 0)) return false;
    Row a;
    a.fill(1);
    Matrix decomposed = squares_;
    if (!decompose(decomposed) || !iterate(decomposed, nullptr, a)) return false;
    double here = 0, beside = 0;
    for (const Point3& p : sample_.points) here += square(a, placed(p));
    for (const FacetFrame& f : sample_.frames) beside += square(a, placed(f.middle));
    return here * static_cast<double>(sample_.frames.size()) <=
           kMostPart * kMostPart * beside * static_cast<double>(sample_.points.size());
  }

  /// The coefficients of the quadric of the least quotient of the distances and the slopes along the normals.
  std::optional<Row> best() const {
    Matrix weighted = squares_, rises{};
    Row a{};
    Moments moments{};
    for (const FacetFrame& f : sample_.frames) {
      const Point3 at = placed(f.middle);
      const std::array<double, 4> place{at.x, at.y, at.z, 1};
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) moments[i][j] += place[i] * place[j];
      }
      const Row rise = slopes(at, f.normal);
      add_square(rises, rise);
      for (std::size_t i = 0; i < kCount; ++i) a[i] += rise[i];
    }
    add_gradient_squares(weighted, moments, kNormalWeight);
    // The slopes across the normals are what the slopes along them leave of the gradients.
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        weighted[i][j] -= kNormalWeight * rises[i][j];
        rises[j][i] = rises[i][j];
      }
    }
    if (!decompose(weighted) || !iterate(weighted, &rises, a)) return std::nullopt;
    return a;
  }

 private:
  Point3 placed(const Point3& p) const { return (p - sample_.middle) / size_; }

  /// Square of the value of a quadric.
  static double square(const Row& a, const Point3& p) {
    const double value = product(a, terms(p));
    return value * value;
  }

  /// Inverse iteration towards the least eigenvalue of a matrix, divided by `factor` if that is given, from `a`.
  static bool iterate(const Matrix& decomposed, const Matrix* factor, Row& a) {
    for (int step = 0; step < kSteps; ++step) {
      if (factor && step > 0) {
        Row next;
        for (std::size_t i = 0; i < kCount; ++i) next[i] = product((*factor)[i], a);
        a = next;
      }
      const double length = std::sqrt(product(a, a));
      if (!(length > 0)) return false;
      for (double& x : a) x /= length;
      substitute(decomposed, a);
    }
    return true;
  }

  const SurfaceSample& sample_;
  double size_ = 0;
  Matrix squares_{};  ///< lower triangle: sum of the outer products of the points' terms
};

}  // namespace

std::optional<PatchSurface> cone_from_quadric(const SurfaceSample& sample) {
  const QuadricFit fit(sample);
  if (!fit.has_quadric()) return std::nullopt;
  const auto best = fit.best();
  if (!best) return std::nullopt;
  const Row& a = *best;
  const Eigen3 e = symmetric_eigen({{{a[0], a[3] / 2, a[4] / 2}, {a[3] / 2, a[1], a[5] / 2}, {a[4] / 2, a[5] / 2, a[2]}}});
  // The axis is the direction of the eigenvalue that differs most from the two others.
  const std::size_t along = e.values[1] - e.values[0] < e.values[2] - e.values[1] ? 2 : 0;
  PatchSurface s{.kind = SurfaceKind::cone, .at = sample.middle, .axis = e.vectors[along]};
  const Point3 slope(a[6], a[7], a[8]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == along) continue;
    if (e.values[k] == 0) return std::nullopt;
    s.at -= fit.size() * glm::dot(slope, e.vectors[k]) / (2 * e.values[k]) * e.vectors[k];
  }
  // The line of least squares through the points in the half plane beside the axis.
  double n = 0, h = 0, r = 0, hh = 0, hr = 0;
  for (const Point3& p : sample.points) {
    const AxisPlace place = axis_place(s, p);
    n += 1, h += place.along, r += place.radius, hh += place.along * place.along, hr += place.along * place.radius;
  }
  const double divisor = n * hh - h * h;
  if (!(std::abs(divisor) > 0)) return std::nullopt;
  s.slope = (n * hr - h * r) / divisor;
  s.at += h / n * s.axis;
  s.radius = r / n;
  return s;
}

}  // namespace ligne
