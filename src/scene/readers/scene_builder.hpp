#pragma once
/// Builds a scene object by object, for the readers.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/no_index.hpp"
#include "files/omissions.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// The message for a file without faces, with the items that it has instead.
std::string no_faces(const Omissions& left_out);

class SceneBuilder {
 public:
  /// `name` is used in error messages. Counts the stored items in `report`.
  SceneBuilder(const std::string& name, ReadReport& report) : name_(name), report_(report) {}

  void begin_object(std::string name);
  /// Ends the object. An object without faces is dropped with its vertices. Unless the precision is stated by the file, it
  /// is at least that of the decimal grid to which the coordinates were rounded.
  void end_object(double precision, bool is_stated = false);
  /// Adds a vertex and returns its index in the scene. Throws InputError if indices can not hold it.
  std::uint32_t add_vertex(Point3 position);
  /// Adds n vertices for the caller to fill, and returns them.
  std::span<Point3> add_vertices(std::size_t n);
  /// Adds a face to the object; corners are indices in the scene. Returns the index of the face.
  std::uint32_t add_face(std::span<const std::uint32_t> outer);
  /// Adds triangles to the object, three corners each.
  void add_triangles(std::vector<std::uint32_t> corners);
  void add_hole(std::span<const std::uint32_t> hole);
  /// Sets the flags of the corners of the face added last.
  void set_corner_flags(std::span<const std::uint8_t> flags);
  /// Sets the material of the following faces; a new name makes a new entry.
  void use_material(const std::string& name);
  void use_material(std::uint32_t index) { material_ = index; }

  /// Index of the first vertex of the current object.
  std::uint32_t object_vertex_begin() const { return object_.vertex_begin; }
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  /// The scene, not cleaned. Throws InputError with the omissions if it has no faces.
  Scene finish(Axis up_axis, const Omissions& left_out);

 private:
  /// Gives the faces added last their material. The list stays empty while all faces have one material.
  void give_material(std::size_t count);

  const std::string& name_;
  ReadReport& report_;
  Scene scene_;
  Object object_;
  std::map<std::string, std::uint32_t> material_index_;
  std::uint32_t material_ = kNone;        ///< kNone until one is named: material of faces without a name
  std::uint32_t first_material_ = kNone;  ///< material of the first face, and of all while the list is empty
};

}  // namespace ligne
