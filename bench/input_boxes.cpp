#include <algorithm>
#include <cmath>

#include "inputs.hpp"

namespace ligne::bench {

namespace {

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Six times the signed volume of the tetrahedron a, b, c, d.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

using Corners = std::array<Vec3, 3>;

/// Number of edges of `a` that pass through the inside of `b`.
int piercing_edges(const Corners& a, const Corners& b) {
  std::array<bool, 3> above{};
  for (std::size_t k = 0; k < 3; ++k) above[k] = volume(b[0], b[1], b[2], a[k]) > 0;
  if (above[0] == above[1] && above[1] == above[2]) return 0;
  int n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (above[k] == above[(k + 1) % 3]) continue;
    const Vec3 &p = a[k], &q = a[(k + 1) % 3];
    const bool s0 = volume(p, q, b[0], b[1]) > 0, s1 = volume(p, q, b[1], b[2]) > 0, s2 = volume(p, q, b[2], b[0]) > 0;
    if (s0 == s1 && s1 == s2) ++n;
  }
  return n;
}

template <class CornerOf>
std::vector<CubeCorners> make_block(int n, const CornerOf& corner_of) {
  std::vector<CubeCorners> cubes;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        CubeCorners cube;
        for (unsigned v = 0; v < 8; ++v) cube[v] = corner_of(std::array<int, 3>{x, y, z}, v);
        cubes.push_back(cube);
      }
    }
  }
  return cubes;
}

Vec3 lattice_corner(const std::array<int, 3>& cell, unsigned v) {
  return {double(cell[0] + int(v & 1)), double(cell[1] + int(v >> 1 & 1)), double(cell[2] + int(v >> 2 & 1))};
}

}  // namespace

const std::array<std::array<std::uint32_t, 4>, 6> kCubeFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

Vec3 Placement::operator()(const Vec3& p) const {
  return {dot(rows[0], p) + shift[0], dot(rows[1], p) + shift[1], dot(rows[2], p) + shift[2]};
}

std::uint64_t RandomNumbers::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

double RandomNumbers::uniform(double from, double to) {
  return from + (to - from) * (static_cast<double>(next() >> 11) * 0x1p-53);
}

Placement rotation(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  Placement r;
  r.rows = {Vec3{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
            Vec3{s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
            Vec3{s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}};
  return r;
}

TriangleMesh unit_cube() {
  TriangleMesh cube;
  for (unsigned v = 0; v < 8; ++v) cube.positions.push_back({(v & 1) - 0.5, (v >> 1 & 1) - 0.5, (v >> 2 & 1) - 0.5});
  for (const auto& [a, b, c, d] : kCubeFaces) {
    cube.triangles.push_back({a, b, c});
    cube.triangles.push_back({a, c, d});
  }
  return cube;
}

std::vector<Placement> random_boxes(std::size_t n, double side, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<Placement> boxes;
  while (boxes.size() < n) {
    // A point that is uniform in the ball of quaternions gives a uniform rotation.
    std::array<double, 4> q{};
    double length2 = 0;
    do {
      for (double& c : q) c = random.uniform(-1, 1);
      length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    } while (length2 > 1 || length2 < 0x1p-20);
    Placement box = rotation(q[0], q[1], q[2], q[3]);
    for (std::size_t column = 0; column < 3; ++column) {
      const double length = side * random.uniform(0.5, 1.5);
      for (Vec3& row : box.rows) row[column] *= length;
    }
    for (double& c : box.shift) c = random.uniform(0, 1);
    boxes.push_back(box);
  }
  return boxes;
}

std::size_t count_crossing_triangles(const std::vector<Placement>& boxes) {
  const TriangleMesh cube = unit_cube();
  struct Ball {
    double radius = 0;
    std::array<Corners, 12> triangles{};
  };
  std::vector<Ball> balls;
  for (const Placement& box : boxes) {
    Ball ball;
    double diagonal2 = 0;
    for (const Vec3& row : box.rows) diagonal2 += dot(row, row);  // sum of the squared sides
    ball.radius = std::sqrt(diagonal2) / 2;
    for (std::size_t t = 0; t < 12; ++t) {
      for (std::size_t k = 0; k < 3; ++k) ball.triangles[t][k] = box(cube.positions[cube.triangles[t][k]]);
    }
    balls.push_back(ball);
  }
  std::vector<std::size_t> by_x(boxes.size());
  for (std::size_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return boxes[a].shift[0] < boxes[b].shift[0]; });
  double largest = 0;
  for (const Ball& ball : balls) largest = std::max(largest, ball.radius);

  std::size_t pairs = 0;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Ball& a = balls[by_x[i]];
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      const Ball& b = balls[by_x[j]];
      const Vec3 apart = boxes[by_x[j]].shift - boxes[by_x[i]].shift;
      if (apart[0] > a.radius + largest) break;
      const double reach = a.radius + b.radius;
      if (dot(apart, apart) >= reach * reach) continue;
      for (const Corners& s : a.triangles) {
        for (const Corners& t : b.triangles) {
          if (piercing_edges(s, t) + piercing_edges(t, s) > 0) ++pairs;
        }
      }
    }
  }
  return pairs;
}

std::vector<CubeCorners> cube_block(int n) {
  return make_block(n, [](const std::array<int, 3>& cell, unsigned v) { return lattice_corner(cell, v); });
}

std::vector<CubeCorners> turned_block_shared(int n, const Placement& turn) {
  return make_block(n, [&](const std::array<int, 3>& cell, unsigned v) { return turn(lattice_corner(cell, v)); });
}

std::vector<CubeCorners> turned_block_rounded(int n, const Placement& turn) {
  Placement half_diagonal = turn;
  half_diagonal.shift = {0, 0, 0};
  return make_block(n, [&](const std::array<int, 3>& cell, unsigned v) {
    const Vec3 centre = turn({cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5});
    return centre + half_diagonal({(v & 1) - 0.5, (v >> 1 & 1) - 0.5, (v >> 2 & 1) - 0.5});
  });
}

}  // namespace ligne::bench
