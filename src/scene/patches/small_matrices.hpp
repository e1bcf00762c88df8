#pragma once
/// Symmetric systems of three equations and fewer than ten.

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/point.hpp"

namespace ligne {

using Matrix3 = std::array<std::array<double, 3>, 3>;  ///< rows of columns

/// Adds the product of p as a column and q as a row.
void add_product(Matrix3& m, const Point3& p, const Point3& q);

struct Eigen3 {
  std::array<double, 3> values;   ///< ascending
  std::array<Point3, 3> vectors;  ///< unit length
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's rotations.
Eigen3 symmetric_eigen(Matrix3 m);

/// x with m x = b; none where the matrix is singular.
std::optional<Point3> solve(const Matrix3& m, const Point3& b);

/// Number of parameters of the surface with the most: a torus.
inline constexpr std::size_t kMostParameters = 7;
using ParameterRow = std::array<double, kMostParameters>;
using ParameterMatrix = std::array<ParameterRow, kMostParameters>;

/// The first n unknowns of a symmetric positive definite system, of which the lower half is read, by Cholesky's method.
/// False where it is not positive definite.
bool solve_symmetric(ParameterMatrix a, ParameterRow b, std::size_t n, ParameterRow& x);

}  // namespace ligne
