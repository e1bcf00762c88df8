#include "clear/rounded_parts.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

namespace ligne::test {
namespace {

constexpr double kQuarter = 3.14159265358979323846 / 2;

/// A rounded rectangle in the plane of two axes: half of its straight sides, and the radius of its corners.
struct Ring {
  Point3 centre;
  double half_u, half_v, radius;
  Point3 u{1, 0, 0}, v{0, 1, 0};
};

std::vector<Point3> points_of(const Ring& ring, int steps) {
  std::vector<Point3> points;
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner == 0 || corner == 3 ? ring.half_u : -ring.half_u, y = corner < 2 ? ring.half_v : -ring.half_v;
    // A circle has no straight sides: its corners share their ends.
    const int last = ring.half_u == 0 && ring.half_v == 0 ? steps - 1 : steps;
    for (int k = 0; k <= last; ++k) {
      const double turn = kQuarter * (corner + double(k) / steps);
      points.push_back(ring.centre + (x + ring.radius * std::cos(turn)) * ring.u +
                       (y + ring.radius * std::sin(turn)) * ring.v);
    }
  }
  return points;
}

void add(PartTriangles& to, const Point3& a, const Point3& b, const Point3& c) {
  if (a != b && b != c && c != a) to.push_back({a, b, c});
}

/// The shell through the rings, counter-clockwise as seen from the end, closed by a flat side at either end.
PartTriangles loft(const std::vector<Ring>& rings, int steps) {
  PartTriangles triangles;
  std::vector<Point3> below = points_of(rings.front(), steps);
  for (std::size_t i = 2; i < below.size(); ++i) add(triangles, below[0], below[i], below[i - 1]);
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const std::vector<Point3> above = points_of(rings[r], steps);
    for (std::size_t i = 0; i < below.size(); ++i) {
      const std::size_t j = (i + 1) % below.size();
      add(triangles, below[i], below[j], above[j]);
      add(triangles, below[i], above[j], above[i]);
    }
    below = above;
  }
  for (std::size_t i = 2; i < below.size(); ++i) add(triangles, below[0], below[i - 1], below[i]);
  return triangles;
}

/// Rings along an arc of a profile: `out` and `up` are the centre of the arc, from the ring's straight sides and its plane.
void add_arc(std::vector<Ring>& rings, const Ring& straight, double out, double up, double radius, double from, double to,
             int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double turn = from + (to - from) * k / steps;
    Ring ring = straight;
    ring.radius = out + radius * std::cos(turn);
    ring.centre.z = up + radius * std::sin(turn);
    rings.push_back(ring);
  }
}

std::vector<Ring> plate(int steps) {
  const Ring straight{{0, 0, 0}, 17, 12, 0};
  std::vector<Ring> rings;
  add_arc(rings, straight, 0.01, 3, 3, -kQuarter, 0, steps);
  add_arc(rings, straight, 0.01, 11, 3, 0, kQuarter, steps);
  return rings;
}

std::vector<Ring> tray(int steps) {
  const Ring straight{{0, 0, 0}, 30, 18, 0};
  std::vector<Ring> rings;
  add_arc(rings, straight, 4, 4, 4, -kQuarter, -0.1, steps);                // outside at the bottom
  add_arc(rings, straight, 9, 25, 1, -0.1, 2 * kQuarter - 0.1, 2 * steps);  // rim
  add_arc(rings, straight, 3, 5, 3, -0.1, -kQuarter, steps);                // inside at the bottom
  return rings;
}

std::vector<Ring> tube(int steps) {
  const Ring straight{{0, 0, 0}, 0, 0, 0};
  std::vector<Ring> rings;
  rings.push_back({{0, 0, 0}, 0, 0, 14});
  add_arc(rings, straight, 11, 14, 3, 0, kQuarter, steps);               // rounding of the shoulder
  add_arc(rings, straight, 10, 19, 2, -kQuarter, -2 * kQuarter, steps);  // fillet above it
  rings.push_back({{0, 0, 34}, 0, 0, 8});
  rings.push_back({{0, 0, 34}, 0, 0, 5});
  rings.push_back({{0, 0, 6}, 0, 0, 5});
  return rings;
}

/// Rings of one shape round an axis of that distance, from an angle to another one.
void bend(std::vector<Ring>& rings, double half_u, double half_v, double radius, double distance, double angle, int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double turn = angle * k / steps;
    rings.push_back({distance * Point3(std::cos(turn), 0, std::sin(turn)),
                     half_u,
                     half_v,
                     radius,
                     {-std::cos(turn), 0, -std::sin(turn)},
                     {0, 1, 0}});
  }
}

std::vector<Ring> arch(int steps) {
  std::vector<Ring> rings;
  bend(rings, 3, 8, 2, 25, 2 * kQuarter, 2 * steps);
  return rings;
}

std::vector<Ring> elbow(int steps) {
  std::vector<Ring> rings;
  bend(rings, 0, 0, 7, 20, kQuarter, steps);
  Ring first = rings.front(), last = rings.back();
  first.centre.z -= 15;
  last.centre.x -= 15;
  rings.insert(rings.begin(), first);
  rings.push_back(last);
  return rings;
}

}  // namespace

PartTriangles rounded_part(std::string_view name, int steps) {
  if (name == "plate") return loft(plate(steps), steps);
  if (name == "tray") return loft(tray(steps), steps);
  if (name == "tube") return loft(tube(steps), steps);
  if (name == "arch") return loft(arch(steps), steps);
  if (name == "elbow") return loft(elbow(steps), steps);
  throw std::runtime_error("no such part: " + std::string(name));
}

void write_stl(const PartTriangles& triangles, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto write = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  out.write(std::string(80, ' ').data(), 80);
  write(static_cast<std::uint32_t>(triangles.size()));
  for (const std::array<Point3, 3>& triangle : triangles) {
    for (int k = 0; k < 3; ++k) write(0.0f);  // readers take the normal from the corners
    for (const Point3& p : triangle) {
      for (int axis = 0; axis < 3; ++axis) write(static_cast<float>(p[axis]));
    }
    write(std::uint16_t{0});
  }
  if (!out.flush()) throw std::runtime_error("can't write " + file.string());
}

}  // namespace ligne::test
