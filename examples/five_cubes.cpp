#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "models.hpp"

namespace ligne::examples {
namespace {

constexpr double kHalfSide = 40;
constexpr int kCubes = 5;

/// The vector turned about a unit axis (formula of Rodrigues).
Point3 turned(const Point3& v, const Point3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

}  // namespace

Model five_cubes() {
  // The twenty corners are those of a dodecahedron, and this is the axis of one of its faces.
  const Point3 axis = glm::normalize(Point3(1, 0, std::numbers::phi));
  const Point2 square[] = {
      {-kHalfSide, -kHalfSide}, {kHalfSide, -kHalfSide}, {kHalfSide, kHalfSide}, {-kHalfSide, kHalfSide}};
  Model model;
  for (int i = 0; i < kCubes; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCubes;
    const auto turn = [&](const Point3& v) { return turned(v, axis, angle); };
    const Frame frame{{0, 0, 0}, turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1})};
    Solid cube{"cube " + std::to_string(i + 1), {}, {}};
    // Not add_prism: with rounded corners the faces are planar within the precision of the file, which is what readers go
    // by.
    const Ring low = cube.add_ring(frame, square, -kHalfSide), high = cube.add_ring(frame, square, kHalfSide);
    cube.add_bottom(low);
    cube.add_top(high);
    for (std::size_t k = 0; k < low.size(); ++k) {
      const std::size_t next = (k + 1) % low.size();
      cube.faces.push_back({{low[k], low[next], high[next], high[k]}, {}});
    }
    model.solids.push_back(std::move(cube));
  }
  return model;
}

}  // namespace ligne::examples
