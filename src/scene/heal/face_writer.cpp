#include "scene/heal/face_writer.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "scene/clean/compact.hpp"

namespace ligne {

FaceWriter::FaceWriter(Scene& scene) : scene_(scene) {
  faces_.reserve_corners(scene.faces.corners().size());
  first_new_.reserve(scene.faces.size() + 1);
}

void FaceWriter::begin(std::uint32_t f) { first_new_.resize(f + 1, static_cast<std::uint32_t>(faces_.size())); }

void FaceWriter::keep(std::uint32_t f) {
  const PolygonFaces& faces = scene_.faces;
  std::size_t count = 0;
  for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
    const auto contour = faces.contour(f, c);
    if (c == 0)
      faces_.add_face(contour);
    else
      faces_.add_hole(contour);
    count += contour.size();
  }
  if (!scene_.corner_flags.empty()) add_flags(std::span(scene_.corner_flags).subspan(faces.corner_index(f, 0), count));
  add_origin(f);
}

void FaceWriter::replace(std::uint32_t f, const LooseFace& face) {
  std::size_t begin = 0;
  for (const std::uint32_t end : face.contour_end) {
    const auto contour = std::span(face.corners).subspan(begin, end - begin);
    if (begin == 0)
      faces_.add_face(contour);
    else
      faces_.add_hole(contour);
    begin = end;
  }
  add_flags(face.flags);
  add_origin(f);
}

void FaceWriter::replace(std::uint32_t f, const CutTriangle& triangle) {
  faces_.add_face(triangle.vertices);
  add_flags(triangle.flags);
  add_origin(f);
}

void FaceWriter::finish() {
  begin(static_cast<std::uint32_t>(scene_.faces.size()));
  if (!flags_.empty()) flags_.resize(faces_.corners().size(), 0);
  faces_.shrink_to_fit();
  scene_.faces = std::move(faces_);
  scene_.corner_flags = std::move(flags_);
  if (!scene_.face_material.empty()) scene_.face_material = std::move(material_);
  if (!scene_.face_source.empty()) scene_.face_source = std::move(source_);
  Warnings none;  // details stand on faces that stay
  renumber_faces(scene_, first_new_, none);
}

/// Flags come into being with the first corner that has one.
void FaceWriter::add_flags(std::span<const std::uint8_t> flags) {
  if (flags_.empty() && std::all_of(flags.begin(), flags.end(), [](std::uint8_t f) { return f == 0; })) return;
  flags_.resize(faces_.corners().size() - flags.size(), 0);
  flags_.insert(flags_.end(), flags.begin(), flags.end());
}

void FaceWriter::add_origin(std::uint32_t f) {
  if (!scene_.face_material.empty()) material_.push_back(scene_.face_material[f]);
  if (!scene_.face_source.empty()) source_.push_back(scene_.face_source[f]);
}

LooseFace loose_face(const Scene& scene, std::uint32_t f) {
  LooseFace face;
  for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
    const auto contour = scene.faces.contour(f, c);
    const std::size_t first = scene.faces.corner_index(f, c);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      face.corners.push_back(contour[k]);
      face.flags.push_back(scene.corner_flags.empty() ? std::uint8_t{0} : scene.corner_flags[first + k]);
    }
    face.contour_end.push_back(static_cast<std::uint32_t>(face.corners.size()));
  }
  return face;
}

}  // namespace ligne
