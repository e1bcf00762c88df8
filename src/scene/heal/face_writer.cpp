#include "scene/heal/face_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "scene/clean/compact.hpp"

namespace ligne {
namespace {

bool is_zero(std::uint8_t flags) { return flags == 0; }

}  // namespace

void FaceWriter::keep(std::uint32_t first, std::uint32_t last) {
  if (first == last) return;
  parts_.push_back({first, last});
  count_ += last - first;
}

void FaceWriter::replace(std::uint32_t f, const DetachedFace& face) {
  parts_.push_back({f, f + 1, static_cast<std::uint32_t>(others_.size())});
  ++count_;
  std::size_t begin = 0;
  for (const std::uint32_t end : face.contour_end) {
    const auto contour = std::span(face.corners).subspan(begin, end - begin);
    if (begin == 0)
      others_.add_face(contour);
    else
      others_.add_hole(contour);
    begin = end;
  }
  flags_of_others_.insert(flags_of_others_.end(), face.flags.begin(), face.flags.end());
}

void FaceWriter::replace(std::uint32_t f, const CutTriangle& triangle) {
  parts_.push_back({f, f + 1, static_cast<std::uint32_t>(others_.size())});
  ++count_;
  others_.add_face(triangle.vertices);
  flags_of_others_.insert(flags_of_others_.end(), triangle.flags.begin(), triangle.flags.end());
}

void FaceWriter::finish(std::vector<std::uint32_t>* faces) {
  PolygonFaces new_faces;
  std::vector<std::uint8_t> flags;
  std::vector<std::uint32_t> material, source, first;
  constexpr std::size_t kArrays = 5;
  parallel_tasks(kArrays, [&](std::size_t array) {
    if (array == 0) new_faces = this->faces();
    if (array == 1) flags = corner_flags();
    if (array == 2) material = of_origins(scene_.face_material);
    if (array == 3) source = of_origins(scene_.face_source);
    if (array == 4) first = first_new();
  });
  scene_.faces = std::move(new_faces);
  scene_.corner_flags = std::move(flags);
  scene_.face_material = std::move(material);
  scene_.face_source = std::move(source);
  Warnings none;  // no detail is lost: faces with details stay
  renumber_faces(scene_, first, none);
  if (!faces) return;
  std::vector<std::uint32_t> come_from;
  come_from.reserve(faces->size());
  for (const std::uint32_t f : *faces) {
    for (std::uint32_t k = first[f]; k < first[f + 1]; ++k) come_from.push_back(k);
  }
  *faces = std::move(come_from);
}

FaceWriter::Row FaceWriter::row_of(const Part& part) const {
  if (part.other == kNone) return {scene_.faces, scene_.corner_flags, part.first, part.last};
  return {others_, flags_of_others_, part.other, std::size_t{part.other} + 1};
}

PolygonFaces FaceWriter::faces() const {
  PolygonFaces faces;
  if (scene_.faces.all_triangles() && others_.all_triangles()) {
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * count_);
    for (const Part& part : parts_) {
      const Row row = row_of(part);
      const auto from = row.faces.corners().begin();
      corners.insert(corners.end(), from + static_cast<std::ptrdiff_t>(row.corner()),
                     from + static_cast<std::ptrdiff_t>(row.corner_end()));
    }
    faces.append_triangles(std::move(corners));
    return faces;
  }
  faces.reserve_corners(scene_.faces.corners().size() + others_.corners().size());
  for (const Part& part : parts_) {
    const Row row = row_of(part);
    for (std::size_t f = row.first; f < row.last; ++f) {
      faces.add_face(row.faces.contour(f, 0));
      for (std::size_t c = 1; c < row.faces.contour_count(f); ++c) faces.add_hole(row.faces.contour(f, c));
    }
  }
  return faces;
}

/// Flags of the new corners; none if no corner has any.
std::vector<std::uint8_t> FaceWriter::corner_flags() const {
  std::vector<std::uint8_t> flags;
  if (scene_.corner_flags.empty() && std::ranges::all_of(flags_of_others_, is_zero)) return flags;
  flags.reserve(scene_.faces.corners().size() + flags_of_others_.size());
  for (const Part& part : parts_) {
    const Row row = row_of(part);
    if (row.flags.empty()) {
      flags.resize(flags.size() + row.corner_end() - row.corner(), 0);
    } else {
      flags.insert(flags.end(), row.flags.begin() + static_cast<std::ptrdiff_t>(row.corner()),
                   row.flags.begin() + static_cast<std::ptrdiff_t>(row.corner_end()));
    }
  }
  if (std::ranges::all_of(flags, is_zero)) flags = {};
  return flags;
}

/// Values of each new face, copied from the old face that it is or replaces.
std::vector<std::uint32_t> FaceWriter::of_origins(const std::vector<std::uint32_t>& values) const {
  std::vector<std::uint32_t> now;
  if (values.empty()) return now;
  now.reserve(count_);
  for (const Part& part : parts_) now.insert(now.end(), values.begin() + part.first, values.begin() + part.last);
  return now;
}

/// The list that renumber_faces() takes.
std::vector<std::uint32_t> FaceWriter::first_new() const {
  std::vector<std::uint32_t> first;
  first.reserve(scene_.faces.size() + 1);
  std::uint32_t next = 0;
  for (const Part& part : parts_) {
    if (part.first >= first.size()) {  // skipped for a further face in the place of one
      first.resize(part.first, next);
      first.resize(part.last);
      std::iota(first.begin() + part.first, first.end(), next);
    }
    next += part.last - part.first;
  }
  first.resize(scene_.faces.size() + 1, next);
  return first;
}

DetachedFace loose_face(const Scene& scene, std::uint32_t f) {
  DetachedFace face;
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
