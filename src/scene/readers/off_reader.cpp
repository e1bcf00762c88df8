// Source: Geomview Manual, "OFF Files". The format's word is [ST][C][N][4][n]OFF; the counts of vertices, faces and
// edges may follow on its line. Vertices and faces have one line each.

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

class OffReader {
 public:
  explicit OffReader(const ModelReading& in)
      : lines_(as_text(in.file.bytes, in.file.name)), in_(in), builder_(in.file.name, in.report) {}

  Scene read() {
    read_counts();
    builder_.begin_object("");
    for (std::int64_t i = 0; i < vertices_; ++i) read_vertex();
    for (std::int64_t i = 0; i < faces_; ++i) read_face();
    if (next_line(false)) throw error("more lines than the header declares vertices and faces");
    builder_.end_object(precision_.value());
    in_.report.vertices += static_cast<std::size_t>(vertices_);
    return builder_.finish(Axis::z, in_.warnings.left_out());
  }

 private:
  InputError error(const std::string& cause) const {
    return error_at_line(in_.file.name, std::max<std::size_t>(lines_.number(), 1), cause);
  }

  /// Reads the next line that is not blank and not just a comment.
  bool next_line(bool needed) {
    std::string_view line;
    while (lines_.next(line)) {
      line_ = trimmed(line.substr(0, line.find('#')));
      if (!line_.empty()) return true;
    }
    if (needed) throw error("the file ends early");
    return false;
  }

  void read_counts() {
    next_line(true);
    // In many files the counts follow the word without a space: "OFF490 518 0".
    const std::size_t end = line_.find("OFF");
    std::string_view rest = line_;
    const std::string_view word = end == std::string_view::npos ? "" : rest.substr(0, end + 3);
    if (is_off_word(word)) {
      rest.remove_prefix(word.size());
      if (word.find_first_of("4n") != std::string_view::npos)
        throw error(shown(word) + " has more than three dimensions, and is not read");
      if (starts_with_ignoring_case(trimmed(rest), "BINARY"))
        throw error("binary OFF is not read: convert it to text, or to PLY");
      line_ = trimmed(rest);
      if (line_.empty()) next_line(true);
    }
    rest = line_;
    for (std::int64_t* count : {&vertices_, &faces_}) *count = take_count(rest, "a number of vertices and of faces");
    if (vertices_ >= kNone || faces_ >= kNone) throw error("too many vertices or faces");
  }

  std::int64_t take_count(std::string_view& rest, const char* what) const {
    const std::string_view word = take_word(rest);
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value || *value < 0) throw error(shown(word) + " is not " + what);
    return *value;
  }

  void read_vertex() {
    next_line(true);
    Point3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = take_word(line_);
      const std::optional<double> value = number_in(word);
      if (!value) throw error(shown(word) + " is not a coordinate of a vertex");
      precision_.add(word, *value);
      p[k] = *value;
    }
    builder_.add_vertex(p);
  }

  void read_face() {
    next_line(true);
    const std::int64_t n = take_count(line_, "a number of corners");
    corners_.clear();
    const std::size_t first_line = lines_.number();
    for (std::int64_t k = 0; k < n; ++k) {
      if (trimmed(line_).empty()) next_line(true);
      const std::int64_t vertex = take_count(line_, "a corner of a face");
      if (vertex >= vertices_) {
        throw error("face names vertex " + std::to_string(vertex) + " of " + std::to_string(vertices_));
      }
      corners_.push_back(static_cast<std::uint32_t>(vertex));
    }
    // A face of several lines must end at a line end. Otherwise a corner is missing above, and this line is the next
    // face.
    if (lines_.number() != first_line && !trimmed(line_).empty())
      throw error("face from line " + std::to_string(first_line) + " on ends within this line");
    if (n < 3) return in_.warnings.leave_out(n == 2 ? "faces of two corners" : "faces of less than two corners");
    use_color();
    builder_.add_face(corners_);
  }

  /// Reads three or four numbers after the corners: whole ones up to 255, or others up to 1.
  void use_color() {
    std::array<double, 4> color{0, 0, 0, -1};
    bool whole = true;
    std::size_t n = 0;
    for (std::string_view word = take_word(line_); !word.empty() && n < 4; word = take_word(line_), ++n) {
      const std::optional<double> value = number_in(word);
      if (!value) throw error(shown(word) + " is not a number of a colour");
      whole = whole && word.find_first_of(".eE") == std::string_view::npos;
      color[n] = *value;
    }
    if (n == 0) return builder_.use_material(kNone);
    if (n < 3) {
      in_.warnings.leave_out("numbered colours");
      return builder_.use_material(kNone);
    }
    const double most = whole ? 255 : 1;
    for (double& part : color) part = std::clamp(part / most, 0.0, 1.0);
    std::string name = "#";
    for (std::size_t k = 0; k < n; ++k) {
      constexpr char kDigits[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned>(std::lround(color[k] * 255));
      name += kDigits[byte / 16];
      name += kDigits[byte % 16];
    }
    const std::size_t before = builder_.scene().materials.size();
    builder_.use_material(name);
    if (builder_.scene().materials.size() == before) return;
    Material& material = builder_.scene().materials.back();
    material.color = {color[0], color[1], color[2]};
    if (n == 4) material.opacity = color[3];
  }

  LineReader lines_;
  const ModelReading& in_;
  SceneBuilder builder_;
  std::string_view line_;
  std::int64_t vertices_ = 0, faces_ = 0;
  std::vector<std::uint32_t> corners_;
  DecimalPrecision precision_;
};

}  // namespace

bool is_off_word(std::string_view word) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  for (const std::string_view letters : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(letters)) word.remove_prefix(letters.size());
  }
  return word.empty();
}

Scene read_off(const ModelReading& in) { return OffReader(in).read(); }

}  // namespace ligne
