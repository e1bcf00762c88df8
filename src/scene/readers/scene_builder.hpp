#pragma once
/// Puts a scene together object by object, for the readers.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/no_index.hpp"
#include "files/omissions.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Why a file without faces can not be drawn, with what it has in their place.
std::string no_faces(const Omissions& left_out);

class SceneBuilder {
 public:
  /// `name` stands in error messages. Counts what is stored in `report`.
  SceneBuilder(const std::string& name, ReadReport& report) : name_(name), report_(report) {}

  void begin_object(std::string name);
  /// Ends the object; one without faces is forgotten together with its vertices.
  void end_object(double precision);
  /// Index within the scene of a new vertex. Throws InputError beyond what indices can hold.
  std::uint32_t add_vertex(Point3 position);
  /// Adds a face of the object; corners are indices within the scene. Returns its index.
  std::uint32_t add_face(std::span<const std::uint32_t> outer);
  /// Adds triangles of the object: three corners for each.
  void add_triangles(std::vector<std::uint32_t> corners);
  void add_hole(std::span<const std::uint32_t> hole);
  /// Flags of the corners of the face added last.
  void set_corner_flags(std::span<const std::uint8_t> flags);
  /// Material of the faces that follow; entries are made as names come up.
  void use_material(const std::string& name);
  void use_material(std::uint32_t index) { material_ = index; }

  /// Vertices of the object so far begin here.
  std::uint32_t object_vertex_begin() const { return object_.vertex_begin; }
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  /// The scene, not cleaned. Throws InputError when it has no faces, with what was left out.
  Scene finish(Axis up_axis, const Omissions& left_out);

 private:
  /// Gives the faces that were added last their material; the list is empty while all have one.
  void give_material(std::size_t count);

  const std::string& name_;
  ReadReport& report_;
  Scene scene_;
  Object object_;
  std::map<std::string, std::uint32_t> material_index_;
  std::uint32_t material_ = kNone;        ///< kNone until one is named: the material of faces that name none
  std::uint32_t first_material_ = kNone;  ///< that of the first face, and of all while the list is empty
};

}  // namespace ligne
