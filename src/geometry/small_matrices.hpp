#pragma once
/// Linear algebra for small symmetric systems: 3 by 3, and up to kMostParameters unknowns.

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/point.hpp"

namespace ligne {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< m[row][column]

/// Adds the outer product of p and q to m: m[i][j] += p[i] q[j].
void add_product(Matrix3& m, const Point3& p, const Point3& q);

/// Eigenvalues and eigenvectors of a 3 by 3 matrix.
struct Eigen3 {
  std::array<double, 3> values;   ///< ascending
  std::array<Point3, 3> vectors;  ///< unit length, in the order of the values
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's rotations.
Eigen3 symmetric_eigen(Matrix3 m);

/// Solves m x = b. Returns nothing if m is singular.
std::optional<Point3> solve(const Matrix3& m, const Point3& b);

/// Largest parameter_count() of a surface: that of a torus.
inline constexpr std::size_t kMostParameters = 7;
using ParameterRow = std::array<double, kMostParameters>;
using ParameterMatrix = std::array<ParameterRow, kMostParameters>;

/// Solves the symmetric positive definite system a x = b in the first n unknowns by Cholesky decomposition. Reads only
/// the lower triangle of a. Returns false if the matrix is not positive definite.
bool solve_symmetric(ParameterMatrix a, ParameterRow b, std::size_t n, ParameterRow& x);

}  // namespace ligne
