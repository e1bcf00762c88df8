#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "models.hpp"

namespace ligne::examples {
namespace {

constexpr double kRing = 40, kPipe = 20, kTube = 9;  ///< radii of the torus, and of the tube along its knot
constexpr int kTurns = 2, kWindings = 3;             ///< about the axis of the torus, and about its pipe
constexpr std::uint32_t kAlong = 200, kAround = 20;

/// Circle about the knot, at right angles with it, at the angle `u` (0 to 2 pi along the whole knot).
void add_section(Solid& solid, double u) {
  const double around_axis = kTurns * u, around_pipe = kWindings * u;
  const Point3 out(std::cos(around_axis), std::sin(around_axis), 0), along(-out.y, out.x, 0), up(0, 0, 1);
  const double radius = kRing + kPipe * std::cos(around_pipe);
  const Point3 normal = std::cos(around_pipe) * out + std::sin(around_pipe) * up;  // of the torus
  const Point3 tangent =
      kTurns * radius * along + kWindings * kPipe * (std::cos(around_pipe) * up - std::sin(around_pipe) * out);
  const Frame frame{radius * out + kPipe * std::sin(around_pipe) * up, normal, glm::normalize(glm::cross(tangent, normal)),
                    glm::normalize(tangent)};
  solid.add_ring(frame, circle({0, 0}, kTube, kAround), 0);
}

}  // namespace

Model trefoil() {
  Solid knot{"trefoil", {}, {}};
  for (std::uint32_t i = 0; i < kAlong; ++i) add_section(knot, 2 * std::numbers::pi * i / kAlong);
  for (std::uint32_t i = 0; i < kAlong; ++i) {
    for (std::uint32_t j = 0; j < kAround; ++j) {
      const std::uint32_t here = i * kAround, next = (i + 1) % kAlong * kAround, k = (j + 1) % kAround;
      knot.faces.push_back({{here + j, here + k, next + k}, {}});
      knot.faces.push_back({{here + j, next + k, next + j}, {}});
    }
  }
  return {{knot}};
}

}  // namespace ligne::examples
