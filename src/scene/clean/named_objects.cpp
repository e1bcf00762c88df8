#include "scene/clean/named_objects.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/no_index.hpp"
#include "scene/clean/compact.hpp"
#include "scene/model/precision.hpp"

namespace ligne {

std::string object_name(const Object& object, std::size_t number) {
  return object.name.empty() ? "object " + std::to_string(number) : object.name;
}

bool name_fits(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

void keep_objects(Scene& scene, const std::vector<std::uint8_t>& keep, std::size_t first_number) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].name = object_name(scene.objects[i], first_number + i);
  }
  PolygonFaces faces;
  std::vector<std::uint32_t> material, source, first_new;
  std::vector<std::uint8_t> flags;
  first_new.reserve(scene.faces.size() + 1);
  std::size_t object = 0;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    first_new.push_back(static_cast<std::uint32_t>(faces.size()));
    while (object < scene.objects.size() && scene.objects[object].face_end <= f) ++object;
    if (object < scene.objects.size() && !keep[object]) continue;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      if (c == 0)
        faces.add_face(contour);
      else
        faces.add_hole(contour);
      if (scene.corner_flags.empty()) continue;
      const auto first = scene.corner_flags.begin() + static_cast<std::ptrdiff_t>(scene.faces.corner_index(f, c));
      flags.insert(flags.end(), first, first + static_cast<std::ptrdiff_t>(contour.size()));
    }
    if (!scene.face_material.empty()) material.push_back(scene.face_material[f]);
    if (!scene.face_source.empty()) source.push_back(scene.face_source[f]);
  }
  first_new.push_back(static_cast<std::uint32_t>(faces.size()));
  scene.faces = std::move(faces);
  scene.face_material = std::move(material);
  scene.face_source = std::move(source);
  scene.corner_flags = std::move(flags);
  Warnings none;  // warnings about details of unwanted objects are dropped
  renumber_faces(scene, first_new, none);
  drop_unused_vertices(scene);
  std::vector<Object> kept;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (keep[i]) kept.push_back(std::move(scene.objects[i]));
  }
  scene.objects = std::move(kept);
}

void move_object(Scene& scene, std::size_t number, const Point3& by) {
  Object& object = scene.objects[number];
  double largest = 0;
  for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
    Point3& p = scene.vertices[v];
    p += by;
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  }
  object.precision = std::max(object.precision, half_ulp_double(largest));
  for (Detail& detail : scene.details) {
    if (detail.face < object.face_begin || detail.face >= object.face_end) continue;
    for (Point3& p : detail.contour) p += by;
  }
}

ObjectOfFace::ObjectOfFace(const Scene& scene) {
  for (const Object& object : scene.objects) face_end_.push_back(object.face_end);
}

std::uint32_t ObjectOfFace::operator()(std::uint32_t face) const {
  const auto found = std::upper_bound(face_end_.begin(), face_end_.end(), face);
  return found == face_end_.end() ? kNone : static_cast<std::uint32_t>(found - face_end_.begin());
}

}  // namespace ligne
