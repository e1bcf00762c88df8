#include "geometry/small_matrices.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Largest off-diagonal part of a matrix taken as diagonal, relative to the diagonal: half a unit in the last place.
constexpr double kDiagonal = 0x1p-53;
/// Largest number of sweeps of rotations. They converge quadratically, so few are needed.
constexpr int kMostSweeps = 12;

/// Applies the rotation that makes the entry (p, q) of a symmetric matrix zero, to its upper triangle m and to the columns
/// of v. `rest` is the third index.
void rotate(Matrix3& m, Matrix3& v, std::size_t p, std::size_t q, std::size_t rest) {
  const double off = m[p][q];
  if (off == 0) return;
  // The square is infinite where the rotation is too small to matter.
  const double theta = (m[q][q] - m[p][p]) / (2 * off);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(1 + theta * theta));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  const auto turn = [&](double& x, double& y) {
    const double first = x;
    x = c * first - s * y;
    y = s * first + c * y;
  };
  m[p][p] -= t * off;
  m[q][q] += t * off;
  m[p][q] = 0;
  turn(m[std::min(p, rest)][std::max(p, rest)], m[std::min(q, rest)][std::max(q, rest)]);
  for (std::size_t k = 0; k < 3; ++k) turn(v[k][p], v[k][q]);
}

}  // namespace

Eigen3 symmetric_eigen(Matrix3 m) {
  Matrix3 v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const double off = std::abs(m[0][1]) + std::abs(m[0][2]) + std::abs(m[1][2]);
    if (off <= kDiagonal * (std::abs(m[0][0]) + std::abs(m[1][1]) + std::abs(m[2][2]))) break;
    rotate(m, v, 0, 1, 2);
    rotate(m, v, 0, 2, 1);
    rotate(m, v, 1, 2, 0);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) { return m[l][l] < m[r][r]; });
  Eigen3 e{};
  for (std::size_t i = 0; i < 3; ++i) {
    e.values[i] = m[order[i]][order[i]];
    e.vectors[i] = glm::normalize(Point3(v[0][order[i]], v[1][order[i]], v[2][order[i]]));
  }
  return e;
}

std::optional<Point3> solve(const Matrix3& m, const Point3& b) {
  const Point3 c0(m[0][0], m[1][0], m[2][0]), c1(m[0][1], m[1][1], m[2][1]), c2(m[0][2], m[1][2], m[2][2]);
  const Point3 c12 = glm::cross(c1, c2);
  const double det = glm::dot(c0, c12);
  // Smallest determinant relative to the product of the columns' lengths; below it rounding decides.
  constexpr double kSingular = 1e-12;
  if (!(std::abs(det) > kSingular * glm::length(c0) * glm::length(c1) * glm::length(c2))) return std::nullopt;
  return Point3(glm::dot(b, c12), glm::dot(c0, glm::cross(b, c2)), glm::dot(c0, glm::cross(c1, b))) / det;
}

}  // namespace ligne
