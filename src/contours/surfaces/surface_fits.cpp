#include "contours/surfaces/surface_fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Number of terms: x y, xx xy yy, xxx xxy xyy yyy. There is no constant term, since the surface passes through the
/// point itself.
constexpr std::size_t kCubic = 9, kQuadratic = 5;
/// Least number of points beyond the number of terms, so that the residuals show how well the surface fits.
constexpr std::size_t kSpare = 3;

// Adjustable parameters. The squares of residuals are weighted by the inverse sixth power of the distance. The error of
// a cubic grows with the fourth power of the distance, but the inverse eighth power would let two or three points
// determine some terms.
/// Least part of a term's square that the other terms do not determine; with less, the term is unknown.
constexpr double kIndependent = 1e-4;
/// Largest fraction of the points' heights over the tangent plane that a surface may leave unexplained. With more, the
/// points are noise, or lie beyond a sudden change of the curvature.
constexpr double kLeftOver = 0.1;
/// Largest root mean square angle, in radians (11 degrees), by which the points rise from the tangent plane. On coarser
/// meshes a polynomial of degree three oscillates.
constexpr double kMostBent = 0.2;

/// One number for each of two fits. One instruction handles both, with the same result as for one alone.
using Two = double __attribute__((vector_size(2 * sizeof(double))));
constexpr std::size_t kFits = 2;
constexpr Two kBoth = {1, 1};

/// The monomials up to degree six; those of degree d are x^d, x^(d-1) y, ..., y^d. Every product of two terms is one of
/// them, so the normal equations need 27 sums, and not 45.
constexpr std::size_t kMonomials = 27;
using Monomials = std::array<Two, kMonomials>;

Monomials monomials_of(Two x, Two y) {
  const Two xx = x * x, xy = x * y, yy = y * y;
  const Two x3 = xx * x, xxy = xx * y, xyy = x * yy, y3 = yy * y;
  const Two x4 = xx * xx, x3y = x3 * y, xxyy = xx * yy, xy3 = x * y3, y4 = yy * yy;
  const Two x5 = x4 * x, x4y = x4 * y, x3yy = x3 * yy, xxy3 = xx * y3, xy4 = x * y4, y5 = y4 * y;
  return {x,  y,   xx,   xy,   yy,  x3, xxy,    xyy,    y3,      x4,      x3y,     xxyy,   xy3,   y4,
          x5, x4y, x3yy, xxy3, xy4, y5, x5 * x, x5 * y, x4 * yy, x3 * y3, xx * y4, x * y5, y5 * y};
}

/// Index of the first monomial of a degree.
constexpr std::size_t first_of(std::size_t degree) { return degree * (degree + 1) / 2 - 1; }

using Terms = std::array<Two, kCubic>;

Terms terms_of(Two x, Two y) {
  const Two xx = x * x, yy = y * y;
  return {x, y, xx, x * y, yy, xx * x, xx * y, x * yy, yy * y};
}

/// Per pair of terms: the index of the monomial that is their product.
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

using Which = std::array<bool, kFits>;

/// Solves the first N normal equations by elimination, for the fits in `which`. Removes the fits from `which` that have
/// an unknown term (kIndependent).
template <std::size_t N>
void solve(const Monomials& sums, Terms right, Which& which, Terms& solution) {
  std::array<std::array<Two, N>, N> m;  // only the upper triangle is used
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = i; j < N; ++j) m[i][j] = sums[kProducts[i][j]];
  }
  std::array<Two, N> inverse;
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t f = 0; f < kFits; ++f) which[f] = which[f] && m[k][k][f] > kIndependent * sums[kProducts[k][k]][f];
    if (!which[0] && !which[1]) return;
    inverse[k] = kBoth / m[k][k];
    for (std::size_t i = k + 1; i < N; ++i) {
      const Two part = m[k][i] * inverse[k];
      for (std::size_t j = i; j < N; ++j) m[i][j] -= part * m[k][j];
      right[i] -= part * right[k];
    }
  }
  Terms found{};
  for (std::size_t i = N; i-- > 0;) {
    Two sum = right[i];
    for (std::size_t j = i + 1; j < N; ++j) sum -= m[i][j] * found[j];
    found[i] = sum * inverse[i];
  }
  for (std::size_t f = 0; f < kFits; ++f) {
    if (!which[f]) continue;
    for (std::size_t i = 0; i < kCubic; ++i) solution[i][f] = found[i][f];
  }
}

/// Two unit vectors perpendicular to a normal and to each other.
struct Frame {
  Point3 x, y;

  explicit Frame(const Point3& normal) {
    const Point3 size = glm::abs(normal);
    const Point3 least = size.x <= size.y && size.x <= size.z ? Point3{1, 0, 0}
                         : size.y <= size.z                   ? Point3{0, 1, 0}
                                                              : Point3{0, 0, 1};
    x = glm::normalize(glm::cross(normal, least));
    y = glm::cross(normal, x);
  }
};

/// The points of two fits, in units of their mean distance from the fitted place.
class Places {
 public:
  struct Place {
    Two x, y, height, square, weight;
  };

  Places(const std::array<PointsRound, kFits>& fits, Which& which) {
    places_.reserve(std::max(fits[0].points.size(), fits[1].points.size()));
    for (std::size_t f = 0; f < kFits; ++f) which[f] = which[f] && add(fits[f], f);
  }

  const std::vector<Place>& all() const { return places_; }
  const Frame& frame(std::size_t fit) const { return frames_[fit]; }
  double mean(std::size_t fit) const { return means_[fit]; }

 private:
  /// Adds the points of fit f. Returns false if their mean distance is not positive. Points of weight zero pad the fit
  /// with fewer points.
  bool add(const PointsRound& round, std::size_t f) {
    double sum = 0;
    for (const Point3& p : round.points) sum += glm::distance(p, round.at);
    means_[f] = sum / double(round.points.size());
    if (!(means_[f] > 0)) return false;
    frames_[f] = Frame(round.normal);
    std::size_t k = 0;
    for (const Point3& p : round.points) {
      const Point3 d = (p - round.at) / means_[f];
      const double square = glm::dot(d, d);
      if (!(square > 0)) continue;
      if (k == places_.size()) places_.push_back(Place{Two{}, Two{}, Two{}, kBoth, Two{}});
      Place& place = places_[k++];
      place.x[f] = glm::dot(d, frames_[f].x);
      place.y[f] = glm::dot(d, frames_[f].y);
      place.height[f] = glm::dot(d, round.normal);
      place.square[f] = square;
      place.weight[f] = 1;
    }
    return true;
  }

  std::vector<Place> places_;
  std::array<Frame, kFits> frames_{Frame({0, 0, 1}), Frame({0, 0, 1})};
  std::array<double, kFits> means_{};
};

/// The normal, and its derivative, of the surface whose height over the frame has these terms.
SurfaceFit surface_of(const Point3& normal, const Frame& frame, double mean, const std::array<double, kQuadratic>& s) {
  const auto& [x, y] = frame;
  SurfaceFit fit;
  // The height is h(x, y), and the normal is (-hx, -hy, 1) divided by its length.
  const double length = std::sqrt(1 + s[0] * s[0] + s[1] * s[1]);
  fit.normal = (normal - s[0] * x - s[1] * y) / length;
  // The derivative along the plane of the frame, and then along the tangent plane.
  const double hxx = 2 * s[2] / mean, hxy = s[3] / mean, hyy = 2 * s[4] / mean;
  const Point3 tx = x - glm::dot(x, fit.normal) * fit.normal, ty = y - glm::dot(y, fit.normal) * fit.normal;
  const double xx = -hxx / length, xy = -hxy / length, yy = -hyy / length;
  std::size_t at_entry = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      fit.turn[at_entry++] = xx * tx[i] * tx[j] + xy * (tx[i] * ty[j] + ty[i] * tx[j]) + yy * ty[i] * ty[j];
    }
  }
  return fit;
}

}  // namespace

Point3 turned(const NormalTurn& t, const Point3& d) {
  return {t[0] * d.x + t[1] * d.y + t[2] * d.z, t[1] * d.x + t[3] * d.y + t[4] * d.z, t[2] * d.x + t[4] * d.y + t[5] * d.z};
}

std::array<std::optional<SurfaceFit>, 2> fit_two_surfaces(const std::array<PointsRound, 2>& fits) {
  std::array<std::optional<SurfaceFit>, kFits> found;
  Which which;
  for (std::size_t f = 0; f < kFits; ++f) which[f] = fits[f].points.size() >= kQuadratic + kSpare;
  const Places places(fits, which);
  if (!which[0] && !which[1]) return found;
  Monomials sums{};
  Terms right{};
  for (const auto& [x, y, height, square, one] : places.all()) {
    const Two weight = one / (square * square * square);
    const Monomials monomials = monomials_of(x, y);
#pragma GCC unroll 27
    for (std::size_t i = 0; i < kMonomials; ++i) sums[i] += weight * monomials[i];
    for (std::size_t i = 0; i < kCubic; ++i) right[i] += weight * height * monomials[i];
  }
  Which cubic = which, quadratic;
  for (std::size_t f = 0; f < kFits; ++f) cubic[f] = cubic[f] && fits[f].points.size() >= kCubic + kSpare;
  Terms s{};
  if (cubic[0] || cubic[1]) solve<kCubic>(sums, right, cubic, s);
  for (std::size_t f = 0; f < kFits; ++f) quadratic[f] = which[f] && !cubic[f];
  if (quadratic[0] || quadratic[1]) solve<kQuadratic>(sums, right, quadratic, s);
  // Residuals are compared as angles, so that points at all distances count equally.
  Two left{}, bent{};
  for (const auto& [x, y, height, square, one] : places.all()) {
    const Terms terms = terms_of(x, y);
    Two rest = height - s[0] * terms[0] - s[1] * terms[1];
    bent += rest * rest / square;
    for (std::size_t i = 2; i < kCubic; ++i) rest -= s[i] * terms[i];
    left += rest * rest / square;
  }
  for (std::size_t f = 0; f < kFits; ++f) {
    if (!cubic[f] && !quadratic[f]) continue;
    if (left[f] > kLeftOver * kLeftOver * bent[f]) continue;
    if (bent[f] > kMostBent * kMostBent * double(fits[f].points.size())) continue;
    found[f] = surface_of(fits[f].normal, places.frame(f), places.mean(f), {s[0][f], s[1][f], s[2][f], s[3][f], s[4][f]});
  }
  return found;
}

bool fit_surface(const Point3& at, const Point3& normal, std::span<const Point3> points, SurfaceFit& fit) {
  const auto found = fit_two_surfaces({PointsRound{at, normal, points}, PointsRound{at, normal, {}}})[0];
  if (found) fit = *found;
  return found.has_value();
}

}  // namespace ligne
