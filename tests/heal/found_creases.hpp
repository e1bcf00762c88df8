#pragma once
/// Creases of small models given as text.

#include "scene/creases/find_creases.hpp"
#include "scene/readers/reader.hpp"
#include "support/standard.hpp"

namespace ligne::test {

inline Scene read(const std::string& text, ModelFormat format, bool shading = true) {
  Warnings warnings;
  return read_scene({std::as_bytes(std::span(text)), "model"}, format, {.shading = shading}, warnings);
}

struct Found {
  Scene scene;
  Topology topology;
  Creases creases;
  std::size_t count() const { return std::accumulate(creases.lines.begin(), creases.lines.end(), std::size_t{0}); }
};

inline Found find(Scene scene, double degrees = 30, double surface_degrees = kSurfaceCreaseDegrees) {
  Found found{std::move(scene), {}, {}};
  found.topology = build_topology(found.scene);
  found.creases = find_creases(found.scene, found.topology, {degrees, surface_degrees});
  return found;
}

/// The faces of rows of n + 1 vertices, of which every other row is shifted by half a step.
inline void write_triangles(std::ostream& obj, int n) {
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int v = i * (n + 1) + k + 1, up = v + n + 1;
      if (i % 2 == 0) obj << "f " << v << ' ' << v + 1 << ' ' << up << "\nf " << v + 1 << ' ' << up + 1 << ' ' << up << '\n';
      if (i % 2 == 1) obj << "f " << v << ' ' << v + 1 << ' ' << up + 1 << "\nf " << v << ' ' << up + 1 << ' ' << up << '\n';
    }
}

/// A steep ridge, rounded over about `round`, that runs across an uneven mesh of triangles with edges of about 1; `turned`
/// radians from the direction to which the triangles are perpendicular. Its heights are noisy.
inline Scene rounded_ridge(int n, double round, double turned) {
  std::ostringstream obj;
  std::uint32_t state = 7;
  const auto noise = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 16777216.0 - 0.5;
  };
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double x = k - n / 2.0 + (i % 2) * 0.5 + 0.25 * noise(), y = (i - n / 2.0) * 0.866 + 0.25 * noise();
      const double across = x * std::cos(turned) + y * std::sin(turned);
      obj << "v " << x << ' ' << y << ' ' << 0.3 * noise() - 2 * std::sqrt(across * across + round * round) << '\n';
    }
  write_triangles(obj, n);
  return read(obj.str(), ModelFormat::obj);
}

}  // namespace ligne::test
