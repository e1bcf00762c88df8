#include "scene/heal/face_writer.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "scene/clean/compact.hpp"

namespace ligne {
namespace {

/// Adjustable: the share of the faces that is kept free for others.
constexpr std::size_t kSpare = 16;

}  // namespace

FaceWriter::FaceWriter(Scene& scene) : scene_(scene) {
  // Faces are left out, or some are cut: nothing need be copied for want of room.
  const auto with_some_more = [](std::size_t n) { return n + n / kSpare; };
  faces_.reserve_corners(with_some_more(scene.faces.corners().size()));
  flags_.reserve(with_some_more(scene.corner_flags.size()));
  material_.reserve(with_some_more(scene.face_material.size()));
  source_.reserve(with_some_more(scene.face_source.size()));
  first_new_.reserve(scene.faces.size() + 1);
}

void FaceWriter::begin(std::uint32_t f) { first_new_.resize(f + 1, static_cast<std::uint32_t>(faces_.size())); }

void FaceWriter::keep(std::uint32_t first, std::uint32_t last) {
  if (first == last) return;
  if (!scene_.faces.all_triangles() || !faces_.all_triangles()) {
    for (std::uint32_t f = first; f < last; ++f) keep_polygon(f);
    return;
  }
  begin(first);
  first_new_.resize(last);
  std::iota(first_new_.begin() + first, first_new_.end(), static_cast<std::uint32_t>(faces_.size()));
  const auto own = [&](const auto& of_corners) {
    return std::span(of_corners).subspan(3 * std::size_t{first}, 3 * std::size_t{last - first});
  };
  const auto corners = own(std::as_const(scene_.faces).corners());
  std::copy(corners.begin(), corners.end(), faces_.append_triangles(last - first).begin());
  if (!scene_.corner_flags.empty()) add_flags(own(scene_.corner_flags));
  add_origins(first, last);
}

void FaceWriter::keep_polygon(std::uint32_t f) {
  begin(f);
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
  add_origins(f, f + 1);
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
  add_origins(f, f + 1);
}

void FaceWriter::replace(std::uint32_t f, const CutTriangle& triangle) {
  faces_.add_face(triangle.vertices);
  add_flags(triangle.flags);
  add_origins(f, f + 1);
}

void FaceWriter::finish(std::vector<std::uint32_t>* faces) {
  begin(static_cast<std::uint32_t>(scene_.faces.size()));
  if (!flags_.empty()) flags_.resize(faces_.corners().size(), 0);
  scene_.faces = std::move(faces_);
  scene_.corner_flags = std::move(flags_);
  if (!scene_.face_material.empty()) scene_.face_material = std::move(material_);
  if (!scene_.face_source.empty()) scene_.face_source = std::move(source_);
  Warnings none;  // details stand on faces that stay
  renumber_faces(scene_, first_new_, none);
  if (!faces) return;
  std::vector<std::uint32_t> come_from;
  come_from.reserve(faces->size());
  for (const std::uint32_t f : *faces) {
    for (std::uint32_t k = first_new_[f]; k < first_new_[f + 1]; ++k) come_from.push_back(k);
  }
  *faces = std::move(come_from);
}

/// Flags come into being with the first corner that has one.
void FaceWriter::add_flags(std::span<const std::uint8_t> flags) {
  if (flags_.empty() && std::accumulate(flags.begin(), flags.end(), 0u, std::bit_or<>()) == 0) return;
  flags_.resize(faces_.corners().size() - flags.size(), 0);
  flags_.insert(flags_.end(), flags.begin(), flags.end());
}

void FaceWriter::add_origins(std::uint32_t first, std::uint32_t last) {
  const auto add = [&](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from) {
    if (!from.empty()) to.insert(to.end(), from.begin() + first, from.begin() + last);
  };
  add(material_, scene_.face_material);
  add(source_, scene_.face_source);
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
