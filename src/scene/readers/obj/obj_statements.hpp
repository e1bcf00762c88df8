#pragma once
/// Reads the statements of an OBJ file.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/obj/obj_surfaces.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/subdivision/crease_tags.hpp"

namespace ligne {

struct ObjVertex : ObjControlPoint {
  std::array<std::uint8_t, 3> digits{};  ///< numbers of significant digits of the coordinates, up to 255
};

/// A corner of a face as the file writes it: 1 is the first vertex or normal, -1 the last one so far, and 0 none.
struct ObjCorner {
  std::int64_t vertex = 0, normal = 0;
};

/// Keeps the vertices and normals of a file, and calls a function for every other statement that makes the scene.
class ObjStatements {
 public:
  ObjStatements(std::string_view text, const std::string& name, bool with_shading, bool groups_as_objects,
                Warnings& warnings)
      : lines_(text),
        name_(name),
        with_shading_(with_shading),
        groups_as_objects_(groups_as_objects),
        warnings_(warnings),
        surfaces_(warnings) {}

  /// Reads all statements, up to the first error.
  void run();

  std::function<void(std::span<const ObjCorner>)> on_face = {};
  std::function<void(const ObjPatch&)> on_patch = {};             ///< receives the free-form patches
  std::function<void(const std::string& name)> on_object = {};    ///< called where an object begins
  std::function<void(const std::string& name)> on_material = {};  ///< receives the material of the following faces
  /// Receives the tags of subdivision; null: they are left out.
  CreaseTags* tags = nullptr;

  /// Distinct names of groups in order; empty if the file has objects.
  std::vector<std::string> groups() const { return has_objects_ ? std::vector<std::string>() : group_names_; }
  /// The words of the mtllib statements.
  const std::vector<std::string>& libraries() const { return libraries_; }

  /// The first line with an unknown keyword; empty if there is none.
  const std::string& first_unknown() const { return first_unknown_; }

  const std::vector<std::uint32_t>& normals() const { return normals_; }  ///< packed_direction()
  std::uint32_t smoothing_group() const { return group_; }                ///< of the following faces; 0: none

  const std::vector<ObjVertex>& vertices() const { return vertices_; }
  /// The first error, if any.
  const std::optional<InputError>& error() const { return error_; }
  void fail(const std::string& cause) {
    if (!error_) error_ = error_at_line(name_, line_, cause);
  }

 private:
  /// Joins a line with its continuations.
  bool take_statement();
  bool continues(std::string_view line);
  void take_keyword(std::string_view keyword, std::string_view rest);
  void take_name(std::string_view keyword, std::string_view rest);
  void leave_out(std::string_view keyword);
  void add_vertex(std::string_view rest);
  void take_face(std::string_view words);

  LineReader lines_;
  const std::string& name_;
  bool with_shading_, groups_as_objects_;
  Warnings& warnings_;
  ObjSurfaces surfaces_;
  bool has_objects_ = false;
  std::vector<std::string> group_names_, libraries_;
  std::string_view whole_;
  std::string joined_;
  std::string first_unknown_;
  std::size_t line_ = 0;  ///< first line of the statement read last
  std::vector<ObjVertex> vertices_;
  std::vector<ObjCorner> face_;
  std::vector<std::uint32_t> normals_;
  std::uint32_t group_ = 0;
  std::optional<InputError> error_;
};

}  // namespace ligne
