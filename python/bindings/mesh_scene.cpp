#include "bindings/mesh_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "files/input_error.hpp"
#include "scene/readers/reader.hpp"

namespace ligne::python {
namespace {

std::string range_text(std::size_t count) {
  return count == 0 ? "there are no vertices" : "0 to " + std::to_string(count - 1);
}

template <class T>
std::uint32_t checked_corner(T index, std::size_t row, std::size_t vertex_count) {
  bool within = true;
  if constexpr (std::numeric_limits<T>::is_signed) within = index >= 0;
  if (!within || static_cast<std::uint64_t>(index) >= vertex_count) {
    throw InputError("faces: index " + std::to_string(index) + " of face " + std::to_string(row) +
                     " is not a row of vertices (" + range_text(vertex_count) + ")");
  }
  return static_cast<std::uint32_t>(index);
}

void check_count(std::size_t corners) {
  if (corners >= kNone) throw InputError("faces: more than 4294967294 corners");
}

/// Vertices of one object, in the order of first use by its faces.
class VertexPicker {
 public:
  explicit VertexPicker(const std::vector<Point3>& from) : from_(from), number_(from.size(), kNone) {}

  void begin_object() { used_.clear(); }
  std::uint32_t operator()(std::uint32_t v) {
    if (number_[v] == kNone) {
      number_[v] = static_cast<std::uint32_t>(to_.size());
      to_.push_back(from_[v]);
      used_.push_back(v);
    }
    return number_[v];
  }
  void end_object() {
    for (const std::uint32_t v : used_) number_[v] = kNone;
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(to_.size()); }
  std::vector<Point3> take() { return std::move(to_); }

 private:
  const std::vector<Point3>& from_;
  std::vector<std::uint32_t> number_, used_;
  std::vector<Point3> to_;
};

void add_face(const PolygonFaces& from, std::uint32_t f, PolygonFaces& to, VertexPicker& pick) {
  std::vector<std::uint32_t> corners;
  for (std::size_t c = 0; c < from.contour_count(f); ++c) {
    corners.clear();
    for (const std::uint32_t v : from.contour(f, c)) corners.push_back(pick(v));
    if (c > 0) {
      to.add_hole(corners);
    } else {
      to.add_face(corners);
    }
  }
}

/// Sorts faces by object.
void split_objects(Scene& scene, const FaceLabels& labels, double precision) {
  std::vector<std::uint32_t>& order = scene.face_source;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return labels.object[a] < labels.object[b]; });
  PolygonFaces faces;
  VertexPicker pick(scene.vertices);
  for (std::size_t i = 0; i < order.size();) {
    Object object;
    const std::uint32_t number = labels.object[order[i]];
    object.name = labels.object_names.at(number);
    object.precision = precision;
    object.vertex_begin = pick.count();
    object.face_begin = static_cast<std::uint32_t>(i);
    pick.begin_object();
    for (; i < order.size() && labels.object[order[i]] == number; ++i) add_face(scene.faces, order[i], faces, pick);
    pick.end_object();
    object.vertex_end = pick.count();
    object.face_end = static_cast<std::uint32_t>(i);
    scene.objects.push_back(std::move(object));
  }
  scene.faces = std::move(faces);
  scene.vertices = pick.take();
}

}  // namespace

template <class T>
std::vector<Point3> read_vertices(const MatrixView<T>& vertices) {
  if (vertices.rows >= kNone) throw InputError("vertices: more than 4294967294 rows");
  std::vector<Point3> points(vertices.rows);
  for (std::size_t i = 0; i < vertices.rows; ++i) {
    Point3& p = points[i] = {static_cast<double>(vertices(i, 0)), static_cast<double>(vertices(i, 1)),
                             static_cast<double>(vertices(i, 2))};
    for (int k = 0; k < 3; ++k) {
      if (std::abs(p[k]) <= kLargestCoordinate) continue;
      throw InputError("vertices: row " + std::to_string(i) +
                       (std::isfinite(p[k]) ? " has a coordinate beyond 1.6e60" : " is not finite"));
    }
  }
  return points;
}
template std::vector<Point3> read_vertices(const MatrixView<float>&);
template std::vector<Point3> read_vertices(const MatrixView<double>&);

template <class T>
void read_faces(const MatrixView<T>& corners, const FaceLists& lists, std::size_t vertex_count, PolygonFaces& faces) {
  check_count(corners.rows * corners.columns);
  if (lists.contour_end.empty() && corners.columns == 3) {
    const std::span<std::uint32_t> to = faces.append_triangles(corners.rows);
    for (std::size_t f = 0; f < corners.rows; ++f) {
      for (std::size_t k = 0; k < 3; ++k) to[3 * f + k] = checked_corner(corners(f, k), f, vertex_count);
    }
    return;
  }
  std::vector<std::uint32_t> contour;
  if (lists.contour_end.empty()) {
    for (std::size_t f = 0; f < corners.rows; ++f) {
      contour.clear();
      for (std::size_t k = 0; k < corners.columns; ++k) contour.push_back(checked_corner(corners(f, k), f, vertex_count));
      faces.add_face(contour);
    }
    return;
  }
  std::size_t corner = 0, c = 0;
  for (std::size_t f = 0; f < lists.face_end.size(); ++f) {
    for (bool outer = true; c < lists.face_end[f]; ++c, outer = false) {
      contour.clear();
      for (; corner < lists.contour_end[c]; ++corner) contour.push_back(checked_corner(corners(corner, 0), f, vertex_count));
      if (contour.size() < 3) {
        throw InputError("faces: a contour of face " + std::to_string(f) + " has fewer than three corners");
      }
      if (outer) {
        faces.add_face(contour);
      } else {
        faces.add_hole(contour);
      }
    }
  }
}
template void read_faces(const MatrixView<std::int32_t>&, const FaceLists&, std::size_t, PolygonFaces&);
template void read_faces(const MatrixView<std::int64_t>&, const FaceLists&, std::size_t, PolygonFaces&);
template void read_faces(const MatrixView<std::uint32_t>&, const FaceLists&, std::size_t, PolygonFaces&);
template void read_faces(const MatrixView<std::uint64_t>&, const FaceLists&, std::size_t, PolygonFaces&);

Scene assemble(std::vector<Point3> vertices, PolygonFaces faces, FaceLabels labels, double precision) {
  Scene scene;
  scene.vertices = std::move(vertices);
  scene.faces = std::move(faces);
  scene.face_source.resize(scene.faces.size());
  std::iota(scene.face_source.begin(), scene.face_source.end(), 0u);
  if (labels.object.empty()) {
    Object object;
    object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_end = static_cast<std::uint32_t>(scene.faces.size());
    object.precision = precision;
    scene.objects.push_back(std::move(object));
  } else {
    split_objects(scene, labels, precision);
  }
  scene.materials = std::move(labels.materials);
  for (const std::uint32_t f : scene.face_source) {
    if (!labels.material.empty()) scene.face_material.push_back(labels.material[f]);
  }
  return scene;
}

}  // namespace ligne::python
