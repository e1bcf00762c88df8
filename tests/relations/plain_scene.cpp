#include "relations/plain_scene.hpp"

#include <array>
#include <cstdio>
#include <map>

namespace ligne::test {

PlainScene plain(const Scene& scene) {
  PlainScene result;
  result.up_axis = scene.up_axis;
  for (const Object& object : scene.objects) {
    PlainObject& o = result.objects.emplace_back();
    o.precision = object.precision;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      PlainFace& face = o.faces.emplace_back();
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        Contour& contour = face.contours.emplace_back();
        for (const std::uint32_t v : scene.faces.contour(f, c)) contour.push_back(scene.vertices[v]);
      }
    }
  }
  return result;
}

Scene to_scene(const PlainScene& plain) {
  Scene scene;
  scene.up_axis = plain.up_axis;
  for (const PlainObject& o : plain.objects) {
    Object object;
    object.precision = o.precision;
    object.vertex_begin = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_begin = static_cast<std::uint32_t>(scene.faces.size());
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    for (const PlainFace& face : o.faces) {
      for (const Contour& contour : face.contours) {
        std::vector<std::uint32_t> corners;
        for (const Point3& p : contour) {
          const std::array<double, 3> key{p.x + 0.0, p.y + 0.0, p.z + 0.0};
          const auto [found, fresh] = numbers.emplace(key, static_cast<std::uint32_t>(scene.vertices.size()));
          if (fresh) scene.vertices.push_back(p);
          corners.push_back(found->second);
        }
        &contour == &face.contours.front() ? scene.faces.add_face(corners) : scene.faces.add_hole(corners);
      }
    }
    object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_end = static_cast<std::uint32_t>(scene.faces.size());
    scene.objects.push_back(object);
  }
  return scene;
}

std::string to_json(const PlainScene& plain) {
  constexpr const char* kAxisNames[] = {"x", "y", "z"};
  const auto number = [](double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    return std::string(buffer);
  };
  std::string text = std::string("{\"format\": \"ligne-scene\", \"version\": 1, \"up\": \"") +
                     kAxisNames[static_cast<std::size_t>(plain.up_axis)] + "\", \"objects\": [";
  const char* next_object = "\n";
  for (const PlainObject& o : plain.objects) {
    std::string vertices, faces;
    std::size_t count = 0;
    for (const PlainFace& face : o.faces) {
      std::string contours;
      for (const Contour& contour : face.contours) {
        std::string corners;
        for (const Point3& p : contour) {
          vertices += (count ? ", [" : "[") + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + "]";
          corners += (corners.empty() ? "" : ", ") + std::to_string(count++);
        }
        const bool outer = &contour == &face.contours.front();
        const bool first_hole = !outer && &contour == &face.contours[1];
        contours += (outer ? "\"outer\": [" : first_hole ? ", \"holes\": [[" : ", [") + corners + "]";
      }
      if (face.contours.size() > 1) contours += "]";
      faces += (faces.empty() ? "{" : ",\n  {") + contours + "}";
    }
    text += next_object +
            ("{\"precision\": " + number(o.precision) + ", \"vertices\": [" + vertices + "],\n \"faces\": [" + faces + "]}");
    next_object = ",\n";
  }
  return text + "]}\n";
}

}  // namespace ligne::test
