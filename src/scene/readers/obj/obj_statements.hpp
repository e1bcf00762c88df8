#pragma once
/// Delivers the statements of an OBJ file one at a time to the library that parses them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <streambuf>
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

/// Delivers the statements to the library, one line each, and keeps the vertices itself.
class ObjStatements : public std::streambuf {
 public:
  ObjStatements(std::string_view text, const std::string& name, bool with_shading, bool groups_as_objects,
                Warnings& warnings)
      : lines_(text),
        name_(name),
        with_shading_(with_shading),
        groups_as_objects_(groups_as_objects),
        warnings_(warnings),
        surfaces_(warnings) {}

  /// Called for every free-form patch, between the library's statements.
  std::function<void(const ObjPatch&)> on_patch = {};
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
  /// The first error, if any. It is stored because streams swallow exceptions.
  const std::optional<InputError>& error() const { return error_; }
  void fail(const std::string& cause) {
    if (!error_) error_ = error_at_line(name_, line_, cause);
  }

 protected:
  int_type underflow() override;

 private:
  /// Joins a line with its continuations.
  bool take_statement();
  bool continues(std::string_view line);
  /// Checks the statement; true if it is to be passed to the library.
  bool delivered();
  bool take_name(std::string_view keyword, std::string_view rest);
  void leave_out(std::string_view keyword);
  void add_vertex(std::string_view rest);
  /// Checks that every word is v, v/vt, v//vn or v/vt/vn, and writes them with single blanks and without a comment.
  void write_face(std::string_view words);

  LineReader lines_;
  const std::string& name_;
  bool with_shading_, groups_as_objects_;
  Warnings& warnings_;
  ObjSurfaces surfaces_;
  bool has_objects_ = false;
  std::vector<std::string> group_names_, libraries_;
  std::string_view whole_;
  std::string joined_;
  std::string statement_, first_unknown_;
  std::size_t line_ = 0;  ///< first line of the statement delivered last
  std::vector<ObjVertex> vertices_;
  std::vector<std::uint32_t> normals_;
  std::uint32_t group_ = 0;
  std::optional<InputError> error_;
};

}  // namespace ligne
