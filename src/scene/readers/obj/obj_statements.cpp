#include "scene/readers/obj/obj_statements.hpp"

#include <algorithm>
#include <limits>

#include "base/no_index.hpp"
#include "scene/creases/file_shading.hpp"
#include "scene/model/precision.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {
namespace {

/// Reads the subdivision tags of OBJ files.

/// Sharpness from which an edge is sharp at every level, as in OpenSubdiv, which defines these tags.
constexpr double kSharpest = 10;

/// Reads "2/1/0": numbers of integers, of values and of texts.
std::optional<std::array<std::size_t, 3>> tag_counts(std::string_view word) {
  std::array<std::size_t, 3> counts{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t slash = k < 2 ? word.find('/') : word.size();
    if (slash == std::string_view::npos) return std::nullopt;
    const std::optional<std::int64_t> count = parse_integer(word.substr(0, slash));
    if (!count || *count < 0) return std::nullopt;
    counts[k] = static_cast<std::size_t>(*count);
    word.remove_prefix(std::min(slash + 1, word.size()));
  }
  return counts;
}

struct Tag {
  std::vector<std::uint32_t> vertices;
  std::vector<float> sharpness;
};

std::optional<Tag> tag_values(std::string_view words) {
  const auto counts = tag_counts(take_word(words));
  if (!counts) return std::nullopt;
  Tag tag;
  while (tag.vertices.size() < (*counts)[0]) {
    const std::optional<std::int64_t> vertex = parse_integer(take_word(words));
    if (!vertex || *vertex < 0 || *vertex >= kNone) return std::nullopt;
    tag.vertices.push_back(static_cast<std::uint32_t>(*vertex));
  }
  while (tag.sharpness.size() < (*counts)[1]) {
    const std::optional<double> value = number_in(take_word(words));
    if (!value) return std::nullopt;
    tag.sharpness.push_back(*value >= kSharpest ? kAlwaysSharp : static_cast<float>(std::max(*value, 0.0)));
  }
  return tag;
}

/// Reads the words after a `t`, the tags of OpenSubdiv's examples: `crease I/F/S v0 v1 ... sharpness ...` and `corner
/// I/F/S v ... sharpness ...` with I vertices, numbered from 0, and F values of sharpness, one for all or one each. An
/// edge with a sharpness of 10 or more stays sharp. Other tags are counted as left out. Sets `cause` to a phrase if the
/// words are wrong; it stays empty otherwise.
void take_tag(std::string_view words, CreaseTags& tags, Warnings& warnings, std::string& cause) {
  const std::string_view kind = take_word(words);
  const bool is_crease = kind == "crease";
  if (!is_crease && kind != "corner") return warnings.leave_out("tags " + shown(kind));
  const std::optional<Tag> tag = tag_values(words);
  const std::size_t named = !tag ? 0 : is_crease ? tag->vertices.size() - !tag->vertices.empty() : tag->vertices.size();
  if (named == 0 || (tag->sharpness.size() != 1 && tag->sharpness.size() != named)) {
    cause =
        "tag that is not of the form t " + std::string(kind) + (is_crease ? " 2/1/0 V V SHARPNESS" : " 1/1/0 V SHARPNESS");
    return;
  }
  for (std::size_t i = 0; i < named; ++i) {
    const float sharpness = tag->sharpness[tag->sharpness.size() == 1 ? 0 : i];
    if (!(sharpness > 0)) continue;
    const std::uint32_t v = tag->vertices[i];
    if (!is_crease) {
      tags.corners.push_back({v, sharpness});
      continue;
    }
    const auto [low, high] = std::minmax(v, tag->vertices[i + 1]);
    tags.edges.push_back({low, high, sharpness});
  }
}

/// Statements about shading and display, or beside the faces, which can be skipped without loss.
constexpr std::array<std::string_view, 15> kIgnoredStatements{"vt",    "vn",     "vp",       "s",          "mg",
                                                              "lod",   "bevel",  "c_interp", "d_interp",   "ctech",
                                                              "stech", "usemap", "maplib",   "shadow_obj", "trace_obj"};

/// Whether a word is "nan", "-inf" or the like, which some programs write for unknown colours.
bool is_no_finite_number(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return starts_with_ignoring_case(word, "nan") || starts_with_ignoring_case(word, "inf");
}

/// Three numbers, or zero if they are not: normals only affect shading.
Point3 three_numbers(std::string_view rest) {
  Point3 numbers(0);
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> value = number_in(take_word(rest));
    if (!value) return Point3(0);
    numbers[k] = *value;
  }
  return numbers;
}

/// The corner that a word v, v/vt, v//vn or v/vt/vn names.
std::optional<ObjCorner> corner_in(std::string_view word) {
  std::array<std::int64_t, 3> indices{};
  for (std::size_t part = 0; part < 3; ++part) {
    const std::size_t slash = word.find('/');
    const std::string_view index = word.substr(0, slash);
    const std::optional<std::int64_t> value = parse_integer(index);
    const bool in_range = value && *value >= -std::numeric_limits<int>::max() && *value <= std::numeric_limits<int>::max();
    if (!in_range && (part == 0 || !index.empty())) return std::nullopt;
    indices[part] = value.value_or(0);
    if (slash == std::string_view::npos) return ObjCorner{indices[0], indices[2]};
    word.remove_prefix(slash + 1);
  }
  return std::nullopt;
}

}  // namespace

void ObjStatements::run() {
  while (!error_ && take_statement()) {
    std::string_view rest = trimmed(whole_);
    if (rest.empty() || rest[0] == '#') continue;
    const std::string_view keyword = take_word(rest);
    take_keyword(keyword, rest);
  }
}

/// Whether a backslash at the end continues the line. It does not in comments and at the end of a name, such as a
/// Windows folder.
bool ObjStatements::continues(std::string_view line) {
  if (line.empty() || line.back() != '\\') return false;
  std::string_view rest = trimmed(line);
  if (rest[0] == '#') return false;
  const std::string_view keyword = take_word(rest);
  const bool names = keyword == "usemtl" || keyword == "mtllib" || keyword == "o" || keyword == "g" || keyword == "usemap";
  if (!names || rest.size() < 2 || is_blank(rest[rest.size() - 2])) return true;
  warnings_.add("names that end in a backslash kept as they are");
  return false;
}

bool ObjStatements::take_statement() {
  std::string_view line;
  if (!lines_.next(line)) return false;
  line_ = lines_.number();
  if (!continues(line)) {
    whole_ = line;
    return true;
  }
  joined_.clear();
  while (!line.empty() && line.back() == '\\') {
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

void ObjStatements::take_keyword(std::string_view keyword, std::string_view rest) {
  if (keyword == "v") return add_vertex(rest);
  if (keyword == "f" || keyword == "fo") return take_face(rest);  // fo: faces in files before version 2
  if (keyword == "vt" || (keyword == "vn" && !with_shading_)) return;
  if (keyword == "vn") return normals_.push_back(packed_direction(three_numbers(rest)));
  if (with_shading_ && keyword == "s") {
    const std::optional<std::int64_t> group = parse_integer(take_word(rest));  // or "off"
    group_ = group && *group > 0 && *group < kNone ? static_cast<std::uint32_t>(*group) : 0;
    return;
  }
  if (keyword == "g" || keyword == "o" || keyword == "usemtl") return take_name(keyword, rest);
  if (keyword == "mtllib") {
    libraries_.emplace_back(trimmed(without_comment(rest)));
    return;
  }
  std::string cause;
  if (keyword == "t" && tags) {
    take_tag(rest, *tags, warnings_, cause);
    if (!cause.empty()) fail(cause);
    return;
  }
  if (!surfaces_.take(keyword, rest, vertices_.size(), cause)) leave_out(keyword);
  if (!cause.empty()) fail(cause);
  if (const std::optional<ObjPatch> patch = surfaces_.closed(); patch && on_patch) on_patch(*patch);
}

void ObjStatements::take_name(std::string_view keyword, std::string_view rest) {
  std::string name(trimmed(without_comment(rest)));
  if (keyword == "usemtl") return on_material(name);
  if (keyword == "o") {
    has_objects_ = true;
    return on_object(name);
  }
  if (name.empty()) name = "default";
  if (groups_as_objects_ && !has_objects_) on_object(name);
  if (std::ranges::find(group_names_, name) == group_names_.end()) group_names_.push_back(std::move(name));
}

void ObjStatements::leave_out(std::string_view keyword) {
  if (std::ranges::find(kIgnoredStatements, keyword) != kIgnoredStatements.end()) return;
  if (keyword == "l") return warnings_.leave_out("lines (l)");
  if (keyword == "p") return warnings_.leave_out("points (p)");
  if (keyword == "t") return warnings_.leave_out("tags of subdivision (t), which --subdivide reads");
  if (first_unknown_.empty()) first_unknown_ = trimmed(whole_);
  warnings_.leave_out("statements " + shown(keyword));
}

void ObjStatements::add_vertex(std::string_view rest) {
  constexpr int kMostNumbers = 8;  // x y z, an optional weight, an optional colour with optional opacity
  ObjVertex vertex;
  std::optional<double> weight;
  int n = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word[0] == '#') break;
    const std::optional<double> value = number_in(word);
    // With more than four numbers, those after the third include a colour, which is not drawn.
    const bool is_color = n > 3 || (n == 3 && !trimmed(rest).empty());
    if (!value && !(is_color && is_no_finite_number(word))) return fail(shown(word) + " is not a coordinate of a vertex");
    if (n < 3) {
      vertex.position[n] = *value;
      vertex.digits[n] = static_cast<std::uint8_t>(std::min(significant_digits(word), 255));
    }
    if (n == 3) weight = value.value_or(1);
    if (++n > kMostNumbers) return fail("vertex with more than 8 numbers");
  }
  if (n < 3) return fail("vertex with " + std::to_string(n) + " coordinates, needs 3");
  if (n == 4 || n == kMostNumbers) vertex.weight = *weight;
  vertices_.push_back(vertex);
}

void ObjStatements::take_face(std::string_view words) {
  face_.clear();
  words = words.substr(0, words.find('#'));
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    const std::optional<ObjCorner> corner = corner_in(word);
    if (!corner) return fail(shown(word) + " is not a corner of a face (v, v/vt, v//vn or v/vt/vn)");
    face_.push_back(*corner);
  }
  if (face_.size() < 3) return fail("face with " + std::to_string(face_.size()) + " corners, needs 3 or more");
  on_face(face_);
}

}  // namespace ligne
