#pragma once
/// A model file in which every triangle is found by its number: binary STL, and binary PLY of triangles only.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "files/mapped_file.hpp"
#include "geometry/point.hpp"
#include "scene/readers/ply/ply_records.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads triangles of the file repeatedly, from several threads, without storing them. Triangles and vertices have the
/// numbers that read_scene() gives them before it cleans the scene.
class TriangleFile {
 public:
  /// Returns null for other files, with the reason as a phrase in `why`. If the file is faulty, read_scene() reports
  /// the fault.
  static std::unique_ptr<TriangleFile> open(const std::filesystem::path& file, std::string& why);

  std::size_t triangle_count() const { return triangles_.records.count; }
  std::size_t vertex_count() const { return vertex_count_; }
  const std::string& name() const { return name_; }
  ReadReport report() const;

  /// Checks all numbers: every triangle refers to existing vertices, every coordinate is finite. Throws InputError, as
  /// read_scene() does. Returns false if a face is not a triangle.
  bool check();
  /// Object::precision; known after check().
  double precision() const { return precision_; }

  /// The corners of triangles [begin, end), three each.
  void read_triangles(std::size_t begin, std::size_t end, Point3* corners) const;
  /// The vertices [begin, end).
  void read_vertices(std::size_t begin, std::size_t end, Point3* positions) const;
  /// Releases the memory of the pages that were read.
  void forget_triangles(std::size_t begin, std::size_t end) const;
  void forget_vertices(std::size_t begin, std::size_t end) const;

 private:
  TriangleFile(MappedFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  bool find_stl();
  /// Returns an empty phrase, or the reason why the file is not usable.
  std::string find_ply();
  Point3 vertex(std::size_t i) const;
  void forget(const PlyRecords& records, std::size_t begin, std::size_t end) const;
  void check_vertices();
  bool check_faces() const;

  MappedFile file_;
  std::string name_;
  ModelFormat format_ = ModelFormat::stl_binary;
  PlyTriples vertices_;     ///< STL: items are triangles, and fields are those of their first corners
  PlyTriangles triangles_;  ///< STL: without fields
  std::size_t vertex_count_ = 0;
  bool is_float32_ = true;
  double precision_ = 0;
};

}  // namespace ligne
