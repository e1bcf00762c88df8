#include "scene/model/polygon_faces.hpp"

#include <algorithm>
#include <utility>

namespace ligne {

void PolygonFaces::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t corners[3] = {a, b, c};
  add_face(corners);
}

void PolygonFaces::add_face(std::span<const std::uint32_t> outer) {
  if (face_begin_.empty() && outer.size() != 3) write_offsets();
  corners_.insert(corners_.end(), outer.begin(), outer.end());
  if (face_begin_.empty()) return;
  contour_begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  face_begin_.push_back(static_cast<std::uint32_t>(contour_begin_.size() - 1));
}

void PolygonFaces::add_hole(std::span<const std::uint32_t> hole) {
  if (face_begin_.empty()) write_offsets();
  corners_.insert(corners_.end(), hole.begin(), hole.end());
  contour_begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  face_begin_.back() = static_cast<std::uint32_t>(contour_begin_.size() - 1);
}

std::span<std::uint32_t> PolygonFaces::append_triangles(std::size_t n) {
  const std::size_t first = corners_.size();
  corners_.resize(first + 3 * n);
  if (!face_begin_.empty()) {
    for (std::size_t i = 1; i <= n; ++i) {
      contour_begin_.push_back(static_cast<std::uint32_t>(first + 3 * i));
      face_begin_.push_back(static_cast<std::uint32_t>(contour_begin_.size() - 1));
    }
  }
  return {corners_.data() + first, 3 * n};
}

void PolygonFaces::append_triangles(std::vector<std::uint32_t> corners) {
  if (corners_.empty()) {
    corners_ = std::move(corners);
  } else {
    std::ranges::copy(corners, append_triangles(corners.size() / 3).begin());
  }
}

void PolygonFaces::shrink_to_fit() {
  corners_.shrink_to_fit();
  contour_begin_.shrink_to_fit();
  face_begin_.shrink_to_fit();
}

void PolygonFaces::write_offsets() {
  const std::size_t n = corners_.size() / 3;
  contour_begin_.resize(n + 1);
  face_begin_.resize(n + 1);
  for (std::size_t f = 0; f <= n; ++f) {
    contour_begin_[f] = static_cast<std::uint32_t>(3 * f);
    face_begin_[f] = static_cast<std::uint32_t>(f);
  }
}

}  // namespace ligne
