// The format has no written standard; this reader follows the output of 3D Studio R2 to R4. Each line is complete in
// itself, and headings tell the meaning of the lines below them:
//
//   Named object: "Box"                      then one of:
//     Tri-mesh, Vertices: 8 Faces: 12        mesh
//       Vertex list: / Vertex 0: X: 1 Y: 2 Z: 3
//       Face list:   / Face 0: A:0 B:1 C:2 AB:1 BC:1 CA:0   / Material:"name"  (of the face above it)   / Smoothing: 1, 2
//     Direct light                           Position: X:1 Y:2 Z:3
//     Camera (50mm)                          Position: / Target: / Bank angle:
//
// Blank lines and "Page n" can occur anywhere.

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/studio/studio_camera.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Takes `key` off the front of a line, after any blanks; false if the line does not begin with it.
bool take_key(std::string_view& line, std::string_view key) {
  const std::string_view text = trimmed(line);
  if (!starts_with_ignoring_case(text, key)) return false;
  line = text.substr(key.size());
  return true;
}

/// The text between the first quote and the last, or the trimmed text if there are not two.
std::string unquoted(std::string_view text) {
  const std::size_t first = text.find('"'), last = text.rfind('"');
  if (first == std::string_view::npos || first == last) return std::string(trimmed(text));
  return std::string(text.substr(first + 1, last - first - 1));
}

class AscReader {
 public:
  explicit AscReader(const ModelReading& in)
      : lines_(as_text(in.file.bytes, in.file.name)), in_(in), builder_(in.file.name, in.report) {}

  Scene read() {
    std::string_view line;
    while (lines_.next(line)) read_line(trimmed(line));
    end_object();
    return builder_.finish(Axis::z, in_.warnings.left_out());
  }

 private:
  enum class Part { none, mesh, light, camera };
  struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint8_t, 3> flags{};
    std::string material;
    std::uint32_t smoothing = 0;  ///< one bit per group
  };

  /// Parses "1, 2, 17": at most 32 groups. Other words are skipped.
  static std::uint32_t smoothing_groups(std::string_view line) {
    std::uint32_t groups = 0;
    while (!line.empty()) {
      const std::size_t comma = std::min(line.find(','), line.size());
      const std::optional<std::int64_t> group = parse_integer(trimmed(line.substr(0, comma)));
      if (group && *group >= 1 && *group <= 32) groups |= 1u << (*group - 1);
      line.remove_prefix(std::min(comma + 1, line.size()));
    }
    return groups;
  }

  InputError error(const std::string& cause) const { return error_at_line(in_.file.name, lines_.number(), cause); }

  void read_line(std::string_view line) {
    if (line.empty() || take_key(line, "Page ")) return;
    if (take_key(line, "Named object:")) {
      end_object();
      object_name_ = unquoted(line);
    } else if (take_key(line, "Tri-mesh")) {
      begin_mesh(line);
    } else if (take_key(line, "Vertex list:") || take_key(line, "Face list:")) {
      need_mesh();
    } else if (take_key(line, "Smoothing:")) {
      need_mesh();
      if (!faces_.empty()) faces_.back().smoothing = smoothing_groups(line);
    } else if (take_key(line, "Vertex ")) {
      add_vertex(line);
    } else if (take_key(line, "Face ")) {
      add_face(line);
    } else if (take_key(line, "Material:")) {
      need_mesh();
      if (faces_.empty()) throw error("material before the first face");
      faces_.back().material = unquoted(line);
    } else if (take_key(line, "Direct light") || take_key(line, "Spotlight") || take_key(line, "Omni")) {
      end_object();
      part_ = Part::light;
    } else if (take_key(line, "Camera")) {
      begin_camera(line);
    } else if (take_key(line, "Position:")) {
      add_position(line);
    } else if (part_ == Part::camera && take_key(line, "Target:")) {
      end_camera(line);
    } else if (take_key(line, "Bank angle:")) {
      bank(line);
    } else if (!is_left_out(line)) {
      in_.warnings.leave_out("lines " + shown(line.substr(0, line.find_first_of(":=0123456789"))));
    }
  }

  static bool is_left_out(std::string_view line) {
    for (const std::string_view key :
         {"Ambient light color:", "Light color:", "Target:", "Mapped", "Hotspot", "Falloff", "Background", "Layer:"}) {
      if (take_key(line, key)) return true;
    }
    return false;
  }

  void need_mesh() const {
    if (part_ != Part::mesh) throw error("mesh data outside a tri-mesh");
  }

  /// Takes "KEY number" off the front of a line; returns the number as a word.
  std::string_view take_field(std::string_view& line, std::string_view key) const {
    if (!take_key(line, key)) throw error("expected '" + std::string(key) + "', found " + shown(trimmed(line)));
    return take_word(line);
  }

  std::uint32_t take_count(std::string_view& line, std::string_view key) const {
    const std::string_view word = take_field(line, key);
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value || *value < 0 || *value >= std::int64_t{kNone}) {
      throw error(shown(word) + " after '" + std::string(key) + "' is not a whole number in range");
    }
    return static_cast<std::uint32_t>(*value);
  }

  Point3 take_point(std::string_view& line, DecimalPrecision& precision) const {
    constexpr std::string_view keys[3] = {"X:", "Y:", "Z:"};
    Point3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = take_field(line, keys[k]);
      const std::optional<double> value = number_in(word);
      if (!value) throw error(shown(word) + " is not a coordinate");
      precision.add(word, *value);
      p[k] = *value;
    }
    return p;
  }

  void begin_mesh(std::string_view line) {
    end_object();
    take_key(line, ",");
    vertex_count_ = take_count(line, "Vertices:");
    face_count_ = take_count(line, "Faces:");
    part_ = Part::mesh;
    builder_.begin_object(object_name_);
    precision_ = {};
  }

  /// Reads "0: X: 1 Y: 2 Z: 3"; the number is that of the vertex. Further fields (U: V:) are ignored.
  void add_vertex(std::string_view line) {
    need_mesh();
    check_number(line, vertices_, vertex_count_, "vertex");
    builder_.add_vertex(take_point(line, precision_));
    ++vertices_;
  }

  /// Reads "0: A:0 B:1 C:2 AB:1 BC:1 CA:0"; the flags may be absent.
  void add_face(std::string_view line) {
    need_mesh();
    check_number(line, static_cast<std::uint32_t>(faces_.size()), face_count_, "face");
    constexpr std::string_view corner_keys[3] = {"A:", "B:", "C:"}, edge_keys[3] = {"AB:", "BC:", "CA:"};
    Face face;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = take_count(line, corner_keys[k]);
      if (vertex >= vertex_count_) {
        throw error("face names vertex " + std::to_string(vertex) + " of " + std::to_string(vertex_count_));
      }
      face.corners[k] = builder_.object_vertex_begin() + vertex;
    }
    if (!trimmed(line).empty()) {
      for (int k = 0; k < 3; ++k) face.flags[k] = take_count(line, edge_keys[k]) == 0 ? kCornerFileHidden : 0;
    }
    faces_.push_back(std::move(face));
  }

  void check_number(std::string_view& line, std::uint32_t expected, std::uint32_t count, const std::string& what) const {
    const std::size_t colon = line.find(':');
    const std::string_view word = trimmed(line.substr(0, colon));
    if (colon == std::string_view::npos || parse_integer(word) != std::int64_t{expected}) {
      throw error("expected " + what + " " + std::to_string(expected) + ", found " + shown(word));
    }
    if (expected >= count) throw error(what + " " + std::to_string(expected) + " of a mesh with " + std::to_string(count));
    line.remove_prefix(colon + 1);
  }

  /// Reads "(50mm)": the focal length.
  void begin_camera(std::string_view line) {
    end_object();
    part_ = Part::camera;
    camera_ = {};
    camera_.name = object_name_;
    constexpr double kUsualLensMm = 50;
    const std::size_t open = line.find('('), unit = line.find("mm");
    const bool has_lens = open != std::string_view::npos && unit != std::string_view::npos && open < unit;
    const double lens_mm =
        (has_lens ? number_in(line.substr(open + 1, unit - open - 1)) : std::nullopt).value_or(kUsualLensMm);
    set_lens(camera_, lens_mm);
  }

  void end_camera(std::string_view line) {
    DecimalPrecision unused;
    camera_.forward = take_point(line, unused) - camera_.eye;
    if (glm::length(camera_.forward) > 0 && camera_.fov_degrees < 180) builder_.scene().cameras.push_back(camera_);
    part_ = Part::none;
  }

  /// Turns the camera read last about its line of sight.
  void bank(std::string_view line) {
    const std::optional<double> degrees = number_in(take_word(line));
    if (!degrees || builder_.scene().cameras.empty()) return;
    bank_camera(builder_.scene().cameras.back(), *degrees);
  }

  void add_position(std::string_view line) {
    if (part_ == Part::camera) {
      DecimalPrecision unused;
      camera_.eye = take_point(line, unused);
      return;
    }
    if (part_ != Part::light) throw error("position outside a light or camera");
    DecimalPrecision unused;
    builder_.scene().lights.push_back({Light::Kind::point, take_point(line, unused)});
    part_ = Part::none;
  }

  void end_object() {
    if (part_ == Part::mesh) {
      if (vertices_ != vertex_count_ || faces_.size() != face_count_) {
        throw error("mesh " + shown(object_name_) + " ends with " + std::to_string(vertices_) + " of " +
                    std::to_string(vertex_count_) + " vertices and " + std::to_string(faces_.size()) + " of " +
                    std::to_string(face_count_) + " faces");
      }
      for (const Face& face : faces_) {
        if (face.material.empty())
          builder_.use_material(kNone);
        else
          builder_.use_material(face.material);
        builder_.add_face(face.corners);
        builder_.set_corner_flags(face.flags);
        if (in_.shading) in_.shading->face_groups.push_back(face.smoothing);
      }
      builder_.end_object(precision_.value());
      in_.report.vertices += vertices_;
    }
    part_ = Part::none;
    vertices_ = 0;
    faces_.clear();
  }

  LineReader lines_;
  const ModelReading& in_;
  SceneBuilder builder_;
  Part part_ = Part::none;
  SceneCamera camera_;  ///< the camera being read
  std::string object_name_;
  std::uint32_t vertex_count_ = 0, face_count_ = 0;  ///< from the heading of the mesh
  std::uint32_t vertices_ = 0;                       ///< read so far
  std::vector<Face> faces_;                          ///< read so far; a material line follows its face
  DecimalPrecision precision_;
};

}  // namespace

Scene read_asc(const ModelReading& in) {
  if (in.shading) in.shading->groups_are_bits = true;
  return AscReader(in).read();
}

}  // namespace ligne
