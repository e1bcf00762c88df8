#include "contours/surface_fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// Products of terms are terms of a higher degree, up to six. Of degree d: x^d, x^(d-1) y, ..., y^d. So the normal equations
/// are made of 27 sums, and not of 45. One more, so that they go in pairs.
constexpr std::size_t kMonomials = 28;
using Monomials = std::array<double, kMonomials>;

Monomials monomials_of(double x, double y) {
  const double xx = x * x, xy = x * y, yy = y * y;
  const double x3 = xx * x, xxy = xx * y, xyy = x * yy, y3 = yy * y;
  const double x4 = xx * xx, x3y = x3 * y, xxyy = xx * yy, xy3 = x * y3, y4 = yy * yy;
  const double x5 = x4 * x, x4y = x4 * y, x3yy = x3 * yy, xxy3 = xx * y3, xy4 = x * y4, y5 = y4 * y;
  return {x,  y,   xx,   xy,   yy,  x3, xxy,    xyy,    y3,      x4,      x3y,     xxyy,   xy3,    y4,
          x5, x4y, x3yy, xxy3, xy4, y5, x5 * x, x5 * y, x4 * yy, x3 * y3, xx * y4, x * y5, y5 * y, 0};
}

/// Where those of a degree begin.
constexpr std::size_t first_of(std::size_t degree) { return degree * (degree + 1) / 2 - 1; }

using Terms = std::array<double, kCubic + 1>;

/// A point as the equations see it: its terms, its height over the tangent plane, and the square of its distance.
struct Sample {
  Terms terms;
  double height, square;
};

/// Which monomials the products of two terms are.
constexpr auto kProducts = [] {
  const auto degree = [](std::size_t k) { return k < first_of(2) ? 1 : k < first_of(3) ? 2 : 3; };
  std::array<std::array<std::uint8_t, kCubic>, kCubic> which{};
  for (std::size_t i = 0; i < kCubic; ++i) {
    for (std::size_t j = 0; j < kCubic; ++j) {
      const std::size_t a = degree(i), b = degree(j);
      which[i][j] = static_cast<std::uint8_t>(first_of(a + b) + (i - first_of(a)) + (j - first_of(b)));
    }
  }
  return which;
}();

/// Solves the first N normal equations by elimination; false where a term is not known.
template <std::size_t N>
bool solve(const Monomials& sums, Terms right, Terms& solution) {
  constexpr std::size_t kRow = (N + 1) / 2 * 2;
  std::array<std::array<double, kRow>, N> m{};  // the upper half counts
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = i; j < N; ++j) m[i][j] = sums[kProducts[i][j]];
  }
  std::array<double, N> inverse;
  for (std::size_t k = 0; k < N; ++k) {
    if (!(m[k][k] > kIndependent * sums[kProducts[k][k]])) return false;
    inverse[k] = 1 / m[k][k];
    for (std::size_t i = k + 1; i < N; ++i) {
      const double part = m[k][i] * inverse[k];
      for (std::size_t j = i / 2 * 2; j < kRow; ++j) m[i][j] -= part * m[k][j];
      right[i] -= part * right[k];
    }
  }
  solution = {};
  for (std::size_t i = N; i-- > 0;) {
    double sum = right[i];
    for (std::size_t j = i + 1; j < N; ++j) sum -= m[i][j] * solution[j];
    solution[i] = sum * inverse[i];
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
  Monomials sums{};
  Terms right{};
  std::vector<Sample> samples;
  samples.reserve(points.size());
  for (const Point3& p : points) {
    const Point3 d = (p - at) / mean;
    const double square = glm::dot(d, d);
    if (!(square > 0)) continue;
    const double weight = 1 / (square * square * square), height = glm::dot(d, normal);
    const Monomials monomials = monomials_of(glm::dot(d, x), glm::dot(d, y));
    Sample& sample = samples.emplace_back(Sample{{}, height, square});
    std::copy_n(monomials.begin(), kCubic, sample.terms.begin());
    for (std::size_t i = 0; i < kMonomials; ++i) sums[i] += weight * monomials[i];
    for (std::size_t i = 0; i < right.size(); ++i) right[i] += weight * height * sample.terms[i];
  }
  Terms s{};
  const bool cubic = points.size() >= kCubic + kSpare && solve<kCubic>(sums, right, s);
  if (!cubic && !solve<kQuadratic>(sums, right, s)) return false;
  // As angles, so that points count alike at any distance.
  double left = 0, bent = 0;
  for (const auto& [terms, height, square] : samples) {
    double rest = height - s[0] * terms[0] - s[1] * terms[1];
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
