#pragma once
/// Converts arrays to a scene.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne::python {

/// A matrix of numbers in the memory of numpy, with any strides.
template <class T>
struct MatrixView {
  const std::byte* data = nullptr;
  std::size_t rows = 0, columns = 0;
  std::ptrdiff_t row_step = 0, column_step = 0;  ///< bytes

  T operator()(std::size_t row, std::size_t column) const {
    T value;
    const auto offset = static_cast<std::ptrdiff_t>(row) * row_step + static_cast<std::ptrdiff_t>(column) * column_step;
    __builtin_memcpy(&value, data + offset, sizeof value);
    return value;
  }
};

/// Corners of faces: face f has [begin[f], begin[f + 1]); all faces have equal length if `begin` is empty.
struct FaceLists {
  std::vector<std::uint32_t> contour_end;  ///< in corners; empty: every face is one contour of as many corners as columns
  std::vector<std::uint32_t> face_end;     ///< in contours
};

/// Objects and materials of faces, by number.
struct FaceLabels {
  std::vector<std::uint32_t> object;  ///< per face, or empty: one object
  std::vector<std::string> object_names;
  std::vector<std::uint32_t> material;  ///< per face, or empty
  std::vector<Material> materials;
};

/// Returns the vertices. Throws InputError if one is not finite.
template <class T>
std::vector<Point3> read_vertices(const MatrixView<T>& vertices);

/// Returns the faces. Throws InputError for an index of `vertex_count` or more.
template <class T>
void read_faces(const MatrixView<T>& corners, const FaceLists& lists, std::size_t vertex_count, PolygonFaces& faces);

/// Assembles the scene. Objects own ranges of vertices and faces, so faces are sorted by object, and vertices that
/// several objects share are duplicated. `face_source` gets the input number of each face. `precision`: of all
/// coordinates.
Scene assemble(std::vector<Point3> vertices, PolygonFaces faces, FaceLabels labels, double precision);

}  // namespace ligne::python
