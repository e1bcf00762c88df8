#pragma once
/// Linear algebra for small symmetric systems, whose size is known to the compiler.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/point.hpp"

namespace ligne {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< m[row][column]

/// Adds the outer product of p and q to m: m[i][j] += p[i] q[j].
inline void add_product(Matrix3& m, const Point3& p, const Point3& q) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += p[i] * q[j];
  }
}

/// Eigenvalues and eigenvectors of a 3 by 3 matrix.
struct Eigen3 {
  std::array<double, 3> values;   ///< ascending
  std::array<Point3, 3> vectors;  ///< unit length, in the order of the values
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's rotations.
Eigen3 symmetric_eigen(Matrix3 m);

/// Solves m x = b. Returns nothing if m is singular.
std::optional<Point3> solve(const Matrix3& m, const Point3& b);

/// Replaces the lower triangle of a symmetric positive definite matrix by that of its Cholesky decomposition. Returns false
/// if the matrix is not positive definite.
template <std::size_t kSize>
bool decompose(std::array<std::array<double, kSize>, kSize>& a) {
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = sum / a[j][j];
    }
    double sum = a[i][i];
    for (std::size_t k = 0; k < i; ++k) sum -= a[i][k] * a[i][k];
    if (!(sum > 0)) return false;
    a[i][i] = std::sqrt(sum);
  }
  return true;
}

/// Solves a x = b for a matrix that decompose() has decomposed. `x` is b at first and the solution afterwards.
template <std::size_t kSize>
void substitute(const std::array<std::array<double, kSize>, kSize>& a, std::array<double, kSize>& x) {
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= a[i][k] * x[k];
    x[i] /= a[i][i];
  }
  for (std::size_t i = kSize; i-- > 0;) {
    for (std::size_t k = i + 1; k < kSize; ++k) x[i] -= a[k][i] * x[k];
    x[i] /= a[i][i];
  }
}

/// Solves the symmetric positive definite system a x = b. Reads only the lower triangle of a, and leaves its Cholesky
/// decomposition there. `x` is b at first and the solution afterwards. Returns false if the matrix is not positive definite.
template <std::size_t kSize>
bool solve_symmetric(std::array<std::array<double, kSize>, kSize>& a, std::array<double, kSize>& x) {
  if (!decompose(a)) return false;
  substitute(a, x);
  return true;
}

}  // namespace ligne
