#pragma once
/// Scenes for the methods that compile a tree.

#include <cmath>

#include "support/scenes.hpp"

namespace ligne::test {

/// A ball of 2 n (n - 1) triangles.
inline Scene ball(int n) {
  Scene scene;
  begin_object(scene);
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double a = M_PI * row / n, b = 2 * M_PI * column / n;
      scene.vertices.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const auto at = [&](int r, int c) { return static_cast<std::uint32_t>(r * n + c % n); };
      if (row > 0) scene.faces.add_triangle(at(row, column), at(row + 1, column), at(row, column + 1));
      if (row + 1 < n) scene.faces.add_triangle(at(row, column + 1), at(row + 1, column), at(row + 1, column + 1));
    }
  }
  end_object(scene);
  return scene;
}

}  // namespace ligne::test
