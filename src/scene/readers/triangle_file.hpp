#pragma once
/// A model file of which every triangle can be found by its number: binary STL, and binary PLY of triangles alone.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "files/mapped_file.hpp"
#include "geometry/point.hpp"
#include "scene/readers/ply/ply_header.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads triangles of the file again and again, from several threads, without storing them. The triangles and vertices have
/// the numbers that read_scene() gives them before it cleans the scene.
class TriangleFile {
 public:
  /// nullptr, and in `why` the reason as a phrase, where the file is none of these; what is wrong with it, if that is the
  /// cause, reading it tells.
  static std::unique_ptr<TriangleFile> open(const std::filesystem::path& file, std::string& why);

  std::size_t triangle_count() const { return triangles_.count; }
  std::size_t vertex_count() const { return vertices_.count; }
  const std::string& name() const { return name_; }
  ReadReport report() const;

  /// Looks at all numbers: every triangle names vertices that are there, every coordinate is finite. Throws InputError, as
  /// read_scene() does. False where a face is no triangle.
  bool check();
  /// Object::precision; known after check().
  double precision() const { return precision_; }

  /// The corners of triangles [begin, end), three each.
  void read_triangles(std::size_t begin, std::size_t end, Point3* corners) const;
  /// The vertices [begin, end).
  void read_vertices(std::size_t begin, std::size_t end, Point3* positions) const;
  /// Gives back the memory in which they were looked at.
  void forget_triangles(std::size_t begin, std::size_t end) const;
  void forget_vertices(std::size_t begin, std::size_t end) const;

 private:
  /// Records of one size.
  struct Records {
    std::size_t begin = 0, size = 0, count = 0;
    std::size_t end() const { return begin + size * count; }
  };
  struct Coordinate {
    PlyType type = PlyType::float32;
    std::size_t offset = 0;  ///< in the vertex
  };

  TriangleFile(MappedFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  bool find_stl();
  /// An empty phrase, or why not.
  std::string find_ply();
  std::string take_vertices(const PlyElement& element, std::size_t begin);
  std::string take_faces(const PlyElement& element, std::size_t begin);
  Point3 vertex(std::size_t i) const;
  std::uint32_t corner(std::size_t triangle, std::size_t k) const;
  void check_vertices();
  bool check_faces() const;

  MappedFile file_;
  std::string name_;
  ModelFormat format_ = ModelFormat::stl_binary;
  std::endian order_ = std::endian::little;
  Records triangles_, vertices_;
  Coordinate coordinates_[3];             ///< PLY
  PlyType count_type_ = PlyType::uint8;   ///< PLY: of the number of a face's corners
  PlyType index_type_ = PlyType::uint32;  ///< PLY
  std::size_t list_ = 0;                  ///< PLY: offset in the face of the number of its corners
  bool is_float32_ = true;
  double precision_ = 0;
};

}  // namespace ligne
