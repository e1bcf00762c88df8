#pragma once
/// Polygon faces with holes, as index arrays.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"

namespace ligne {

/// The faces of a scene. A face is a list of contours, the first outer, the others holes; a contour is a cyclic list of
/// corners; a corner holds a vertex index. As long as every face is one contour of three corners, only the corners are
/// stored: corner k of face f is corners()[3 f + k].
class PolygonFaces {
 public:
  std::size_t size() const { return face_begin_.empty() ? corners_.size() / 3 : face_begin_.size() - 1; }
  bool empty() const { return corners_.empty(); }
  bool all_triangles() const { return face_begin_.empty(); }

  /// Number of contours of face f: 1 + number of holes.
  std::size_t contour_count(std::size_t f) const { return face_begin_.empty() ? 1 : face_begin_[f + 1] - face_begin_[f]; }
  /// Vertex indices of contour c of face f.
  std::span<const std::uint32_t> contour(std::size_t f, std::size_t c) const {
    if (face_begin_.empty()) return {corners_.data() + 3 * f, 3};
    const std::size_t k = face_begin_[f] + c;
    return {corners_.data() + contour_begin_[k], corners_.data() + contour_begin_[k + 1]};
  }
  /// Index in corners() of the first corner of contour c of face f; per-corner attributes use the same index.
  std::size_t corner_index(std::size_t f, std::size_t c) const {
    return face_begin_.empty() ? 3 * f : contour_begin_[face_begin_[f] + c];
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Adds a face of one contour (three corners or more).
  void add_face(std::span<const std::uint32_t> outer);
  /// Adds a hole to the face added last.
  void add_hole(std::span<const std::uint32_t> hole);
  /// Appends n triangles and returns their 3 n corners for the caller to fill in.
  std::span<std::uint32_t> append_triangles(std::size_t n);
  /// Appends triangles with the given corners, three each.
  void append_triangles(std::vector<std::uint32_t> corners);

  std::span<const std::uint32_t> corners() const { return corners_; }
  std::span<std::uint32_t> corners() { return corners_; }
  /// Keeps the first n faces. Requires all_triangles() and n <= size().
  void truncate_triangles(std::size_t n) { corners_.resize(3 * n); }
  /// Reserves memory for n corners in all.
  void reserve_corners(std::size_t n) { corners_.reserve(n); }
  void shrink_to_fit();

 private:
  void write_offsets();

  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> contour_begin_;  ///< first corner of each contour, and the end; empty while all are triangles
  std::vector<std::uint32_t> face_begin_;     ///< first contour of each face, and the end; empty while all are triangles
};

}  // namespace ligne
