#pragma once
/// Balls and tori of triangles about the z axis.

#include "scene/model/scene_parts.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// A torus with `around` circles of `across` corners; the first corner lies `first` steps from the outermost circle.
inline Scene torus(double ring, double tube, std::uint32_t around, std::uint32_t across, double first = 0) {
  Scene scene;
  begin_object(scene, "torus");
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * (k + first) / across;
      const double r = ring + tube * std::cos(v);
      scene.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return (i + a) % around * across + (k + b) % across; };
      scene.faces.add_triangle(at(0, 0), at(1, 0), at(1, 1));
      scene.faces.add_triangle(at(0, 0), at(1, 1), at(0, 1));
    }
  }
  end_object(scene);
  return scene;
}

/// A ball with poles and `rings` circles of latitude of `around` corners, each at the radius of its circle and its place;
/// 0 and rings + 1 are the poles. Without the strip of faces before the meridian `first`.
inline Scene ball(std::uint32_t around, std::uint32_t rings,
                  const std::function<double(std::uint32_t ring, std::uint32_t place)>& radius, std::uint32_t first = 0) {
  Scene scene;
  begin_object(scene, "ball");
  for (std::uint32_t ring = 0; ring <= rings + 1; ++ring) {
    const double latitude = std::numbers::pi * (ring / double(rings + 1) - 0.5);
    const bool is_pole = ring == 0 || ring == rings + 1;
    for (std::uint32_t i = 0; i < (is_pole ? 1 : around); ++i) {
      const double longitude = 2 * std::numbers::pi * i / around, r = radius(ring, i), across = r * std::cos(latitude);
      scene.vertices.emplace_back(is_pole ? 0 : across * std::cos(longitude), is_pole ? 0 : across * std::sin(longitude),
                                  is_pole ? (ring == 0 ? -r : r) : r * std::sin(latitude));
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * around + i % around; };
  for (std::uint32_t i = first; i < around; ++i) {
    scene.faces.add_triangle(0, at(1, i + 1), at(1, i));
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
      scene.faces.add_triangle(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      scene.faces.add_triangle(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
    scene.faces.add_triangle(at(rings, i), at(rings, i + 1), 1 + rings * around);
  }
  end_object(scene);
  return scene;
}

}  // namespace ligne::test
