/// Eigenvalues of 3 by 3 matrices, and systems of equations.

#include "geometry/small_matrices.hpp"

#include <random>

#include <glm/geometric.hpp>

#include "support/test.hpp"

namespace ligne::test {
namespace {

/// A symmetric matrix with these eigenvalues.
Matrix3 matrix_of(const std::array<double, 3>& values, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-1, 1);
  const Point3 x = glm::normalize(Point3(place(random), place(random), place(random)));
  const Point3 y = glm::normalize(glm::cross(x, Point3(place(random), place(random), place(random))));
  const std::array<Point3, 3> frame{x, y, glm::cross(x, y)};
  Matrix3 m{};
  for (std::size_t i = 0; i < 3; ++i) add_product(m, values[i] * frame[i], frame[i]);
  return m;
}

Point3 product(const Matrix3& m, const Point3& p) {
  Point3 sum(0.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum[i] += m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] * p[j];
  }
  return sum;
}

TEST(SmallMatrices, HaveTheirEigenvaluesAndVectors) {
  std::mt19937 random(1);
  for (const std::array<double, 3>& values :
       {std::array<double, 3>{1, 2, 3}, {0, 1e-6, 1}, {0, 0, 1}, {-2, -2, 5}, {1e-12, 1e-9, 1e-9}, {0, 0, 0}, {4, 4, 4}}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Matrix3 m = matrix_of(values, random);
      const Eigen3 e = symmetric_eigen(m);
      const double size = std::max(std::abs(values[0]), std::abs(values[2]));
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(e.values[i], values[i], 1e-14 * size);
        EXPECT_LE(glm::distance(product(m, e.vectors[i]), e.values[i] * e.vectors[i]), 1e-14 * size);
        for (std::size_t k = 0; k <= i; ++k) EXPECT_NEAR(glm::dot(e.vectors[i], e.vectors[k]), i == k, 1e-14);
      }
    }
  }
}

TEST(SmallMatrices, SolveSystemsOfFiveEquations) {
  constexpr std::size_t kSize = 5;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    std::array<std::array<double, kSize>, kSize> a{};
    std::array<double, kSize> solution{}, right{};
    for (std::size_t row = 0; row < 2 * kSize; ++row) {
      std::array<double, kSize> terms{};
      for (double& term : terms) term = place(random);
      for (std::size_t i = 0; i < kSize; ++i) {
        for (std::size_t j = 0; j < kSize; ++j) a[i][j] += terms[i] * terms[j];
      }
    }
    for (double& x : solution) x = place(random);
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t j = 0; j < kSize; ++j) right[i] += a[i][j] * solution[j];
    }
    ASSERT_TRUE(solve_symmetric(a, right));
    for (std::size_t i = 0; i < kSize; ++i) EXPECT_NEAR(right[i], solution[i], 1e-12);
  }
}

TEST(SmallMatrices, ThatAreNotPositiveDefiniteAreNotSolved) {
  std::array<std::array<double, 2>, 2> singular{{{1, 0}, {2, 4}}}, negative{{{-1, 0}, {0, 1}}};
  std::array<double, 2> right{1, 2};
  EXPECT_FALSE(solve_symmetric(singular, right));
  EXPECT_FALSE(solve_symmetric(negative, right));
}

}  // namespace
}  // namespace ligne::test
