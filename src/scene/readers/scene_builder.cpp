#include "scene/readers/scene_builder.hpp"

#include <algorithm>
#include <utility>

#include "base/large_vector.hpp"
#include "scene/model/precision.hpp"

namespace ligne {
namespace {

std::uint32_t checked_index(std::size_t n, const std::string& name) {
  if (n >= kNone) throw InputError(name, "holds more than 4294967294 vertices or corners");
  return static_cast<std::uint32_t>(n);
}

}  // namespace

std::string no_faces(const Omissions& left_out) {
  return left_out.empty() ? "holds no faces" : "holds no faces; " + left_out.text();
}

void SceneBuilder::begin_object(std::string name) {
  object_ = Object{};
  object_.name = std::move(name);
  object_.vertex_begin = static_cast<std::uint32_t>(scene_.vertices.size());
  object_.face_begin = static_cast<std::uint32_t>(scene_.faces.size());
}

void SceneBuilder::end_object(double precision, bool is_stated) {
  object_.vertex_end = static_cast<std::uint32_t>(scene_.vertices.size());
  object_.face_end = static_cast<std::uint32_t>(scene_.faces.size());
  const auto positions = std::span(scene_.vertices).subspan(object_.vertex_begin);
  object_.precision = is_stated ? precision : std::max(precision, decimal_grid(positions));
  if (object_.face_begin == object_.face_end) {
    scene_.vertices.resize(object_.vertex_begin);
    return;
  }
  scene_.objects.push_back(std::move(object_));
}

std::uint32_t SceneBuilder::add_vertex(Point3 position) {
  const std::uint32_t index = checked_index(scene_.vertices.size(), name_);
  scene_.vertices.push_back(position);
  return index;
}

std::span<Point3> SceneBuilder::add_vertices(std::size_t n) {
  const std::size_t first = scene_.vertices.size();
  checked_index(first + n, name_);
  scene_.vertices.reserve(first + n);
  prefault(scene_.vertices.data() + first, n * sizeof(Point3));
  scene_.vertices.resize(first + n);
  return std::span(scene_.vertices).subspan(first);
}

std::uint32_t SceneBuilder::add_face(std::span<const std::uint32_t> outer) {
  checked_index(scene_.faces.corners().size() + outer.size(), name_);
  const auto face = static_cast<std::uint32_t>(scene_.faces.size());
  scene_.faces.add_face(outer);
  give_material(1);
  if (!scene_.corner_flags.empty()) scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
  ++report_.faces;
  report_.triangles += outer.size() - 2;
  return face;
}

void SceneBuilder::add_triangles(std::vector<std::uint32_t> corners) {
  checked_index(scene_.faces.corners().size() + corners.size(), name_);
  const std::size_t n = corners.size() / 3;
  scene_.faces.append_triangles(std::move(corners));
  give_material(n);
  if (!scene_.corner_flags.empty()) scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
  report_.faces += n;
  report_.triangles += n;
}

void SceneBuilder::give_material(std::size_t count) {
  std::vector<std::uint32_t>& of_faces = scene_.face_material;
  const std::size_t faces = scene_.faces.size();
  if (faces == count) first_material_ = material_;
  if (of_faces.empty() && material_ == first_material_) return;
  if (of_faces.empty()) of_faces.assign(faces - count, first_material_);
  of_faces.resize(faces, material_);
}

void SceneBuilder::add_hole(std::span<const std::uint32_t> hole) {
  checked_index(scene_.faces.corners().size() + hole.size(), name_);
  scene_.faces.add_hole(hole);
  if (!scene_.corner_flags.empty()) scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
  report_.triangles += hole.size() + 2;  // triangulation repeats the two ends of the hole's bridge
}

void SceneBuilder::set_corner_flags(std::span<const std::uint8_t> flags) {
  if (scene_.corner_flags.empty()) {
    if (std::all_of(flags.begin(), flags.end(), [](std::uint8_t f) { return f == 0; })) return;
    scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
  }
  std::copy(flags.rbegin(), flags.rend(), scene_.corner_flags.rbegin());
}

void SceneBuilder::use_material(const std::string& name) {
  const auto [entry, is_new] = material_index_.try_emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (is_new) {
    scene_.materials.push_back({.name = name});
  }
  material_ = entry->second;
}

Scene SceneBuilder::finish(Axis up_axis, const Omissions& left_out) {
  if (scene_.faces.empty()) throw InputError(name_, no_faces(left_out));
  auto& used = scene_.face_material;
  if (used.empty() && first_material_ == kNone) {
    first_material_ = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.emplace_back();
  }
  if (used.empty() && first_material_ != 0) used.assign(scene_.faces.size(), first_material_);
  if (std::find(used.begin(), used.end(), kNone) != used.end()) {
    const auto plain = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.emplace_back();
    std::replace(used.begin(), used.end(), kNone, plain);
  }
  if (std::all_of(used.begin(), used.end(), [](std::uint32_t m) { return m == 0; })) {
    used.clear();
    used.shrink_to_fit();
  }
  scene_.faces.shrink_to_fit();
  scene_.up_axis = up_axis;
  return std::move(scene_);
}

}  // namespace ligne
