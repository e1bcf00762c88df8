#pragma once
/// A scene as text that `ligne` reads: what a failing test shows.

#include "scene/model/scene.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// The objects with their faces and holes in the format of docs/scene-format.md; reading it gives the same doubles.
/// Materials, details and lights are left out.
inline std::string scene_json(const Scene& scene) {
  std::ostringstream out;
  out.precision(17);
  const auto list = [&](const auto& range, const auto& write) {
    out << '[';
    bool first = true;
    for (const auto& item : range) {
      if (!first) out << ", ";
      first = false;
      write(item);
    }
    out << ']';
  };
  const char* const separator = ",\n  ";
  out << "{\"format\": \"ligne-scene\", \"version\": 1, \"up\": \""
      << "xyz"[static_cast<int>(scene.up_axis)] << "\", \"objects\": [";
  for (const Object& o : scene.objects) {
    out << (&o == scene.objects.data() ? "\n  " : separator) << "{\"precision\": " << o.precision << ", \"vertices\": ";
    const auto begin = scene.vertices.begin();
    list(std::span(begin + o.vertex_begin, begin + o.vertex_end), [&](const Point3& p) {
      out << '[' << p.x + 0.0 << ", " << p.y + 0.0 << ", " << p.z + 0.0 << ']';
    });  // -0 reads as 0
    out << ",\n   \"faces\": [";
    for (std::uint32_t f = o.face_begin; f < o.face_end; ++f) {
      const auto contour = [&](std::size_t c) {
        list(scene.faces.contour(f, c), [&](std::uint32_t v) { out << v - o.vertex_begin; });
      };
      out << (f == o.face_begin ? "{\"outer\": " : ", {\"outer\": ");
      contour(0);
      for (std::size_t c = 1; c < scene.faces.contour_count(f); ++c) {
        out << (c == 1 ? ", \"holes\": [" : ", ");
        contour(c);
      }
      out << (scene.faces.contour_count(f) > 1 ? "]}" : "}");
    }
    out << "]}";
  }
  out << "\n]}\n";
  return out.str();
}

}  // namespace ligne::test
