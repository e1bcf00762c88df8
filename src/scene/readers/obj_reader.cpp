// tinyobjloader takes the statements apart, through its callbacks, which hand over polygons as they stand. It says nothing
// about words where numbers should be (they become 0), faces of two corners, indices that no vertex has (or that overflow),
// and unfinished continuation lines, and gives no line numbers. So it is fed from a stream that delivers one statement at a
// time: the stream joins continued lines, checks the statement's words, and knows the line when a callback comes. Vertex
// positions are read there too: the library's own number parser adds up rounded decimal digits; of random numbers of six
// decimals it gets 48 in a hundred wrong, by up to four units in the last place of a double (2.0.0-rc10, measured).

#include "scene/readers/obj_reader.hpp"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <optional>
#include <streambuf>
#include <vector>

#include "scene/model/precision.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

struct ObjVertex {
  Point3 position;
  int digits = 0;  ///< the most significant digits that a coordinate is written with
};

/// Delivers the statements for the library, one line each, and keeps the vertices to itself.
class StatementStream : public std::streambuf {
 public:
  StatementStream(std::string_view text, const std::string& name, bool with_shading, bool groups_as_objects,
                  Warnings& warnings)
      : lines_(text), name_(name), with_shading_(with_shading), groups_as_objects_(groups_as_objects), warnings_(warnings) {}

  /// Distinct names of groups, in their order; none where the file has objects.
  std::vector<std::string> groups() const { return has_objects_ ? std::vector<std::string>() : group_names_; }

  const std::vector<std::uint32_t>& normals() const { return normals_; }  ///< packed_direction()
  std::uint32_t smoothing_group() const { return group_; }                ///< of the faces that follow; 0: none

  const std::vector<ObjVertex>& vertices() const { return vertices_; }
  /// Line on which the statement delivered last begins.
  std::size_t line() const { return line_; }
  /// What was wrong, if anything: streams swallow exceptions.
  const std::optional<InputError>& error() const { return error_; }
  void fail(const std::string& cause) {
    if (!error_) error_ = error_at_line(name_, line_, cause);
  }

 protected:
  int_type underflow() override {
    while (!error_ && take_statement()) {
      if (!delivered() || error_) continue;
      statement_ += '\n';
      setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
      return traits_type::to_int_type(statement_[0]);
    }
    return traits_type::eof();
  }

 private:
  /// Joins a line and those that continue it.
  bool take_statement() {
    std::string_view line;
    if (!lines_.next(line)) return false;
    line_ = lines_.number();
    const auto continues = [](std::string_view l) { return !l.empty() && l.back() == '\\'; };
    if (!continues(line)) {
      whole_ = line;
      return true;
    }
    joined_.clear();
    while (continues(line)) {
      joined_.append(line.substr(0, line.size() - 1)).append(1, ' ');
      if (!lines_.next(line)) {
        fail("the file ends in a continued line");
        return false;
      }
    }
    joined_.append(line);
    whole_ = joined_;
    return true;
  }

  /// Checks the statement; true when the library is to see it.
  bool delivered() {
    std::string_view rest = trimmed(whole_);
    if (rest.empty() || rest[0] == '#') return false;
    statement_ = rest;
    const std::string_view keyword = take_word(rest);
    if (keyword == "v") {
      add_vertex(rest);
      return false;
    }
    if (with_shading_ && keyword == "vn") {
      normals_.push_back(packed_direction(three_numbers(rest)));
      return false;
    }
    if (with_shading_ && keyword == "s") {
      const std::optional<std::int64_t> group = parse_integer(take_word(rest));  // or "off"
      group_ = group && *group > 0 && *group < kNone ? static_cast<std::uint32_t>(*group) : 0;
      return false;
    }
    if (keyword == "f" || keyword == "fo") {  // fo: faces of files before version 2
      write_face(rest);
      return true;
    }
    if (keyword == "g") {
      std::string group(trimmed(rest).empty() ? "default" : trimmed(rest));
      statement_ = "o " + group;
      if (std::find(group_names_.begin(), group_names_.end(), group) == group_names_.end()) {
        group_names_.push_back(std::move(group));
      }
      return groups_as_objects_ && !has_objects_;
    }
    has_objects_ = has_objects_ || keyword == "o";
    if (keyword == "o" || keyword == "usemtl") {
      // A tab after the keyword, or no name at all, would hide it from the library.
      statement_.assign(keyword).append(1, ' ').append(trimmed(rest));
      return true;
    }
    if (keyword == "l" || keyword == "p")
      warnings_.add("OBJ lines and points left out");
    else if (keyword == "curv" || keyword == "curv2" || keyword == "surf")
      warnings_.add("OBJ free-form curves and surfaces left out");
    return false;
  }

  void add_vertex(std::string_view rest) {
    constexpr int kMostNumbers = 8;  // x y z, a weight or not, a colour with opacity or not
    ObjVertex vertex;
    int n = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (word[0] == '#') break;
      const std::optional<double> value = number_in(word);
      if (!value) return fail(shown(word) + " is not a coordinate of a vertex");
      if (n < 3) {
        vertex.position[n] = *value;
        vertex.digits = std::max(vertex.digits, significant_digits(word));
      }
      if (++n > kMostNumbers) return fail("vertex with more than 8 numbers");
    }
    if (n < 3) return fail("vertex with " + std::to_string(n) + " coordinates, needs 3");
    vertices_.push_back(vertex);
  }

  /// Zero when they are none: normals only say how a surface is shaded.
  static Point3 three_numbers(std::string_view rest) {
    Point3 numbers(0);
    for (int k = 0; k < 3; ++k) {
      const std::optional<double> value = number_in(take_word(rest));
      if (!value) return Point3(0);
      numbers[k] = *value;
    }
    return numbers;
  }

  /// Checks that every word is v, v/vt, v//vn or v/vt/vn and writes them with single blanks, a comment left off.
  void write_face(std::string_view words) {
    statement_.assign(1, 'f');
    words = words.substr(0, words.find('#'));
    std::size_t corners = 0;
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
      if (!is_corner(word)) return fail(shown(word) + " is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
      statement_.append(1, ' ').append(word);
      ++corners;
    }
    if (corners < 3) fail("face with " + std::to_string(corners) + " corners, needs 3 or more");
  }

  static bool is_corner(std::string_view word) {
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = word.find('/');
      const std::string_view index = word.substr(0, slash);
      const std::optional<std::int64_t> value = parse_integer(index);
      const bool in_range = value && *value >= -std::numeric_limits<int>::max() && *value <= std::numeric_limits<int>::max();
      if (!in_range && (part == 0 || !index.empty())) return false;
      if (slash == std::string_view::npos) return true;
      word.remove_prefix(slash + 1);
    }
    return false;
  }

  LineReader lines_;
  const std::string& name_;
  bool with_shading_, groups_as_objects_;
  Warnings& warnings_;
  bool has_objects_ = false;
  std::vector<std::string> group_names_;
  std::string_view whole_;
  std::string joined_;
  std::string statement_;
  std::size_t line_ = 0;
  std::vector<ObjVertex> vertices_;
  std::vector<std::uint32_t> normals_;
  std::uint32_t group_ = 0;
  std::optional<InputError> error_;
};

/// Makes objects from the library's callbacks. Objects own their vertices: one that several use is stored in each.
class ObjScene {
 public:
  ObjScene(const std::string& name, ReadReport& report, StatementStream& stream, FileShading* shading)
      : builder_(name, report), stream_(stream), shading_(shading) {
    builder_.begin_object("");
  }

  void add_face(const tinyobj::index_t* corners, int n) {
    const std::vector<ObjVertex>& vertices = stream_.vertices();
    face_.clear();
    scene_index_.resize(vertices.size(), kNone);
    const auto count = static_cast<std::int64_t>(vertices.size());
    for (int i = 0; i < n; ++i) {
      const std::int64_t written = corners[i].vertex_index;
      const std::int64_t index = written < 0 ? count + written : written - 1;
      if (index < 0 || index >= count) {
        return stream_.fail("face names vertex " + std::to_string(written) + " of " + std::to_string(count));
      }
      face_.push_back(scene_vertex(static_cast<std::size_t>(index)));
    }
    builder_.add_face(face_);
    if (shading_) add_shading(corners, n);
  }

  void begin_object(const char* name) {
    end_object();
    builder_.begin_object(name);
  }

  void use_material(const char* name) { builder_.use_material(std::string(name)); }

  Scene finish() {
    end_object();
    if (shading_) {
      const auto is_zero = [](std::uint32_t value) { return value == 0; };
      for (auto* said : {&shading_->corner_normals, &shading_->face_groups}) {
        if (std::all_of(said->begin(), said->end(), is_zero)) said->clear();
      }
    }
    return builder_.finish(Axis::y);
  }

 private:
  void add_shading(const tinyobj::index_t* corners, int n) {
    const std::vector<std::uint32_t>& normals = stream_.normals();
    const auto count = static_cast<std::int64_t>(normals.size());
    for (int i = 0; i < n; ++i) {
      const std::int64_t written = corners[i].normal_index;
      const std::int64_t index = written < 0 ? count + written : written - 1;
      const bool known = index >= 0 && index < count;
      shading_->corner_normals.push_back(known ? normals[static_cast<std::size_t>(index)] : 0);
    }
    shading_->face_groups.push_back(stream_.smoothing_group());
  }

  std::uint32_t scene_vertex(std::size_t index) {
    std::uint32_t& known = scene_index_[index];
    if (known == kNone) {
      const ObjVertex& vertex = stream_.vertices()[index];
      for (int k = 0; k < 3; ++k) precision_.add(vertex.digits, vertex.position[k]);
      known = builder_.add_vertex(vertex.position);
      used_.push_back(index);
    }
    return known;
  }

  void end_object() {
    builder_.end_object(precision_.value());
    precision_ = {};
    for (const std::size_t index : used_) scene_index_[index] = kNone;
    used_.clear();
  }

  SceneBuilder builder_;
  StatementStream& stream_;
  FileShading* shading_;  ///< or nullptr
  std::vector<std::uint32_t> face_;
  std::vector<std::uint32_t> scene_index_;  ///< per vertex of the file: its copy in the object, or kNone
  std::vector<std::size_t> used_;           ///< vertices of the file that the object has a copy of
  DecimalPrecision precision_;
};

}  // namespace

Scene read_obj(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings,
               FileShading* shading, bool groups_as_objects) {
  StatementStream statements(as_text(bytes, name), name, shading != nullptr, groups_as_objects, warnings);
  ObjScene scene(name, report, statements, shading);
  std::istream stream(&statements);
  stream.exceptions(std::ios::badbit);  // no memory for a statement is no end of the file

  tinyobj::callback_t callback;
  callback.index_cb = [](void* user, tinyobj::index_t* corners, int n) {
    static_cast<ObjScene*>(user)->add_face(corners, n);
  };
  callback.object_cb = [](void* user, const char* object) { static_cast<ObjScene*>(user)->begin_object(object); };
  callback.usemtl_cb = [](void* user, const char* material, int) { static_cast<ObjScene*>(user)->use_material(material); };
  tinyobj::LoadObjWithCallback(stream, callback, &scene);

  if (statements.error()) throw *statements.error();
  report.vertices += statements.vertices().size();
  report.groups = statements.groups();
  return scene.finish();
}

}  // namespace ligne
