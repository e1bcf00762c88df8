#include "contours/surface_fits.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Terms x y, xx xy yy, xxx xxy xyy yyy: the surface passes through the point itself.
constexpr std::size_t kCubic = 9, kQuadratic = 5;
/// Points beyond the number of terms, so that what is left over says how well the surface fits.
constexpr std::size_t kSpare = 3;

// Adjustable parameters. The squares of what is left over are weighed by the inverse sixth power of the distance: what a
// cubic does not know of a surface grows with the fourth power of it, and the eighth would leave some terms to two or three
// points.
/// A term that the others determine but for so much of its square is not known.
constexpr double kIndependent = 1e-4;
/// Of the heights of the points over the tangent plane a surface leaves no more than this share unexplained: other points
/// are noise, or lie beyond a place where the curvature changes at once.
constexpr double kLeftOver = 0.1;
/// A mesh is coarse where its points rise from the tangent plane by more than this angle (11 degrees) on the average: a
/// polynomial of degree three has waves there.
constexpr double kMostBent = 0.2;

using Terms = std::array<double, kCubic>;
using Matrix = std::array<Terms, kCubic>;

Terms terms_of(double x, double y) { return {x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y}; }

/// Solves the first n normal equations; false where a term is not known.
bool solve(Matrix m, Terms right, std::size_t n, Terms& solution) {
  for (std::size_t i = 0; i < n; ++i) {
    const double whole = m[i][i];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      if (j < i) {
        m[i][j] = sum / m[j][j];
      } else {
        if (!(sum > kIndependent * whole)) return false;
        m[i][i] = std::sqrt(sum);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= m[i][k] * right[k];
    right[i] /= m[i][i];
  }
  solution = {};
  for (std::size_t i = n; i-- > 0;) {
    double sum = right[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= m[k][i] * solution[k];
    solution[i] = sum / m[i][i];
  }
  return true;
}

}  // namespace

Point3 turned(const NormalTurn& t, const Point3& d) {
  return {t[0] * d.x + t[1] * d.y + t[2] * d.z, t[1] * d.x + t[3] * d.y + t[4] * d.z, t[2] * d.x + t[4] * d.y + t[5] * d.z};
}

bool fit_surface(const Point3& at, const Point3& normal, std::span<const Point3> points, SurfaceFit& fit) {
  if (points.size() < kQuadratic + kSpare) return false;
  const Point3 size = glm::abs(normal);
  const Point3 least = size.x <= size.y && size.x <= size.z ? Point3{1, 0, 0}
                       : size.y <= size.z                   ? Point3{0, 1, 0}
                                                            : Point3{0, 0, 1};
  const Point3 x = glm::normalize(glm::cross(normal, least)), y = glm::cross(normal, x);
  double mean = 0;
  for (const Point3& p : points) mean += glm::distance(p, at);
  mean /= double(points.size());
  if (!(mean > 0)) return false;
  Matrix m{};
  Terms right{};
  for (const Point3& p : points) {
    const Point3 d = (p - at) / mean;
    const double square = glm::dot(d, d);
    if (!(square > 0)) continue;
    const double weight = 1 / (square * square * square), height = glm::dot(d, normal);
    const Terms terms = terms_of(glm::dot(d, x), glm::dot(d, y));
    for (std::size_t i = 0; i < kCubic; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += weight * terms[i] * terms[j];
      right[i] += weight * terms[i] * height;
    }
  }
  Terms s{};
  const bool cubic = points.size() >= kCubic + kSpare && solve(m, right, kCubic, s);
  if (!cubic && !solve(m, right, kQuadratic, s)) return false;
  // As angles, so that points count alike at any distance.
  double left = 0, bent = 0;
  for (const Point3& p : points) {
    const Point3 d = (p - at) / mean;
    const double square = glm::dot(d, d);
    if (!(square > 0)) continue;
    const Terms terms = terms_of(glm::dot(d, x), glm::dot(d, y));
    double rest = glm::dot(d, normal) - s[0] * terms[0] - s[1] * terms[1];
    bent += rest * rest / square;
    for (std::size_t i = 2; i < kCubic; ++i) rest -= s[i] * terms[i];
    left += rest * rest / square;
  }
  if (left > kLeftOver * kLeftOver * bent || bent > kMostBent * kMostBent * double(points.size())) return false;
  // The height is h(x, y), the normal (-hx, -hy, 1) less its length.
  const double length = std::sqrt(1 + s[0] * s[0] + s[1] * s[1]);
  fit.normal = (normal - s[0] * x - s[1] * y) / length;
  // By the way in the plane of the frame; then in the tangent plane.
  const double hxx = 2 * s[2] / mean, hxy = s[3] / mean, hyy = 2 * s[4] / mean;
  const Point3 tx = x - glm::dot(x, fit.normal) * fit.normal, ty = y - glm::dot(y, fit.normal) * fit.normal;
  const double xx = -hxx / length, xy = -hxy / length, yy = -hyy / length;
  std::size_t at_entry = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      fit.turn[at_entry++] = xx * tx[i] * tx[j] + xy * (tx[i] * ty[j] + ty[i] * tx[j]) + yy * ty[i] * ty[j];
    }
  }
  return true;
}

}  // namespace ligne
