/// Clear lines beside those of the mesh: `--edges all`.

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

/// A ball as a scanner gives it: six square grids of n x n, blown up to a sphere, whose points are off it at random.
std::string scanned_ball(int n, double noise) {
  std::ostringstream points, faces;
  std::mt19937 random(3);
  std::map<std::array<int, 3>, int> numbers;
  const auto number_of = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<int>(numbers.size()) + 1);
    if (is_new) {
      const double x = 2.0 * at[0] / n - 1, y = 2.0 * at[1] / n - 1, z = 2.0 * at[2] / n - 1;
      const double off = noise * (double(random() % 2001) / 1000 - 1), r = (1 + off) / std::hypot(x, y, z);
      points << "v " << r * x << ' ' << r * y << ' ' << r * z << '\n';
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int a, int b) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = side == n ? i + a : i + b;
            at[(axis + 2) % 3] = side == n ? j + b : j + a;
            return number_of(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          faces << "f " << a << ' ' << b << ' ' << c << "\nf " << a << ' ' << c << ' ' << d << '\n';
        }
      }
    }
  }
  return points.str() + faces.str();
}

/// Visible lines of the class, mm.
double length_of(const json& drawing, const std::string& line_class) {
  double sum = 0;
  for (const json& s : drawing["strokes"]) {
    if (!s["visible"].get<bool>() || s["class"] != line_class) continue;
    const auto a = s["points"][0].get<std::array<double, 2>>(), b = s["points"][1].get<std::array<double, 2>>();
    sum += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  return sum;
}

/// Where an outline passes from face to face, lines of the mesh end at every corner: it is no bundle of spurs for that.
TEST_F(DrawTest, OutlinesOfScansStayWhereTheMeshIsDrawn) {
  write("ball.obj", scanned_ball(24, 0.005));
  const double alone = length_of(drawn({"ball.obj"}), "outline");
  const json with_mesh = drawn({"ball.obj", "--edges", "all"});
  EXPECT_GT(alone, 2 * std::numbers::pi * 90) << "at least the round of the ball, which fills the sheet's width";
  EXPECT_GT(length_of(with_mesh, "outline"), alone);
  EXPECT_GT(length_of(with_mesh, "mesh"), 10 * alone);
}

}  // namespace
}  // namespace ligne::test
