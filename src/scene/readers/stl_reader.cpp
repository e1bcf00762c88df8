// Our own reader: the libraries of Debian 12 were tried and none fits. assimp 5.2.5 stores coordinates as float32,
// accepts nan and text without its end, gives no line numbers, and adds 2.6 ms to the start of every run. CGAL's reader
// (LGPL) merges all solids into one soup and gives no line numbers. admesh is GPL. draco reads binary STL only, as
// float32. libigl is not packaged.

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "scene/clean/far_vertices.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/load_bytes.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Count of triangles in files whose writer did not know it, beside 0.
constexpr std::size_t kCountNotWritten = 0xFFFFFFFF;
constexpr std::size_t kHeaderBytes = 80, kPreambleBytes = 84, kTriangleBytes = 50, kNormalBytes = 12;

/// Splits a text into words. Line ends are white space, except that a name extends to the end of its line. A word that
/// begins with "#" begins a comment, which some programs and people write.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  /// The next word; empty at the end of the file.
  std::string_view take() {
    for (;;) {
      std::string_view word = take_word(line_);
      if (word.starts_with('#')) word = line_ = {};
      if (!word.empty() || !lines_.next(line_)) return word;
    }
  }
  std::string_view take_rest_of_line() {
    const std::string_view rest = trimmed(without_comment(line_));
    line_ = {};
    return rest;
  }
  void expect(std::string_view keyword, const char* where) { check(take(), keyword, where); }
  /// Throws unless `word`, the last one taken, is the keyword.
  void check(std::string_view word, std::string_view keyword, const char* where) const {
    if (equal_ignoring_case(word, keyword)) return;
    if (word.empty()) throw error(std::string("the file ends ") + where + "; expected '" + std::string(keyword) + "'");
    throw error("expected '" + std::string(keyword) + "' " + where + ", found " + shown(word));
  }
  InputError error(const std::string& cause) const {
    return error_at_line(name_, std::max<std::size_t>(lines_.number(), 1), cause);
  }

 private:
  LineReader lines_;
  const std::string& name_;
  std::string_view line_;
};

Point3 take_vertex(Words& words, DecimalPrecision& precision) {
  words.expect("vertex", "in a facet");
  Point3 p;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = words.take();
    if (word.empty()) throw words.error("the file ends in a vertex");
    const std::optional<double> value = number_in(word);
    if (!value) throw words.error(shown(word) + " is not a coordinate of a vertex");
    precision.add(word, *value);
    p[k] = *value;
  }
  return p;
}

/// Whether a word between facets or behind a loop is a foreign keyword, such as a colour: letters, and none of STL's words.
bool is_foreign(std::string_view word) {
  for (const std::string_view own : {"solid", "outer", "loop", "vertex", "endloop", "endfacet", "normal"}) {
    if (equal_ignoring_case(word, own)) return false;
  }
  return std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; });
}

/// Reads a facet after its first word.
void read_facet(Words& words, SceneBuilder& builder, DecimalPrecision& precision, Warnings& warnings) {
  // The normal follows from the vertices, and files are careless with it ("nan", missing). So up to kMostNormalWords
  // words before "outer" are skipped.
  constexpr int kMostNormalWords = 4;
  std::string_view word = words.take();
  for (int n = 0; n < kMostNormalWords && !word.empty() && !equal_ignoring_case(word, "outer"); ++n) word = words.take();
  if (word.empty()) throw words.error("the file ends in a facet");
  if (!equal_ignoring_case(word, "outer")) throw words.error("expected 'outer loop' in a facet, found " + shown(word));
  words.expect("loop", "after 'outer'");
  std::array<std::uint32_t, 3> corners{};
  for (std::uint32_t& corner : corners) corner = builder.add_vertex(take_vertex(words, precision));
  words.expect("endloop", "after the three vertices of a facet");
  word = words.take();
  for (; !word.empty() && is_foreign(word); word = words.take()) warnings.leave_out("statements " + shown(word));
  words.check(word, "endfacet", "after a facet's loop");
  builder.add_face(corners);
}

/// Coordinates of a binary file.
struct FoundCoordinates {
  double largest = 0;
  std::size_t not_finite = std::numeric_limits<std::size_t>::max();  ///< the first triangle with such a coordinate
  FoundCoordinates operator+(const FoundCoordinates& o) const {
    return {std::max(largest, o.largest), std::min(not_finite, o.not_finite)};
  }
};

/// Reads as many triangles as there is room for in `vertices` and `corners`.
FoundCoordinates read_triangles(std::span<const std::byte> bytes, std::span<Point3> vertices,
                                std::span<std::uint32_t> corners) {
  const auto read_block = [&](std::size_t begin, std::size_t end) {
    FoundCoordinates found;
    for (std::size_t i = begin; i < end; ++i) {
      const std::byte* p = bytes.data() + kPreambleBytes + kTriangleBytes * i + kNormalBytes;
      for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner) {
        corners[corner] = static_cast<std::uint32_t>(corner);
        for (int k = 0; k < 3; ++k, p += sizeof(float)) {
          const double value = vertices[corner][k] = load_bytes<float>(p, std::endian::little);
          if (!std::isfinite(value)) found.not_finite = std::min(found.not_finite, i);
          found.largest = std::max(found.largest, std::abs(value));
        }
      }
    }
    return found;
  };
  return parallel_reduce(vertices.size() / 3, kShortWorkBlock, FoundCoordinates{}, read_block);
}

/// Throws InputError if the bytes are no triangles, in a file whose count of triangles does not fit its length: a
/// conversion of line ends, or a transfer as text, has moved the numbers.
void check_damage(const FoundCoordinates& found, std::span<const Point3> vertices, std::size_t declared,
                  const std::string& name) {
  std::string numbers = "coordinates are not finite";
  if (found.not_finite >= vertices.size()) {
    const FarVertices far = find_far_vertices(vertices);
    if (far.count == 0) return;
    numbers = "coordinates reach " + rounded(found.largest, 2) + ", most only " + rounded(far.usual, 2);
  }
  throw InputError(name, "the file is damaged, as when line ends were converted: it declares " + std::to_string(declared) +
                             " triangles, its length is that of " + std::to_string(vertices.size() / 3) + ", and " +
                             numbers);
}

}  // namespace

std::size_t stl_triangle_count(std::span<const std::byte> bytes) {
  return bytes.size() < kPreambleBytes ? 0 : load_bytes<std::uint32_t>(bytes.data() + kHeaderBytes, std::endian::little);
}

bool is_binary_stl(std::span<const std::byte> bytes) {
  return bytes.size() >= kPreambleBytes && bytes.size() == kPreambleBytes + kTriangleBytes * stl_triangle_count(bytes);
}

Scene read_stl_ascii(const ModelReading& in) {
  Words words(as_text(in.file.bytes, in.file.name), in.file.name);
  SceneBuilder builder(in.file.name, in.report);
  for (;;) {
    const std::string_view begin = words.take();
    if (begin.empty()) break;
    if (!equal_ignoring_case(begin, "solid")) throw words.error("expected 'solid', found " + shown(begin));
    builder.begin_object(std::string(words.take_rest_of_line()));
    DecimalPrecision precision;
    for (;;) {
      const std::string_view word = words.take();
      if (word.empty()) throw words.error("the file ends in a solid; expected 'facet' or 'endsolid'");
      if (equal_ignoring_case(word, "endsolid")) break;
      if (equal_ignoring_case(word, "end")) {
        words.expect("solid", "after 'end'");
        break;
      }
      if (equal_ignoring_case(word, "facet")) {
        read_facet(words, builder, precision, in.warnings);
      } else if (is_foreign(word)) {
        in.warnings.leave_out("statements " + shown(word));
        words.take_rest_of_line();
      } else {
        throw words.error("expected 'facet' or 'endsolid', found " + shown(word));
      }
    }
    words.take_rest_of_line();
    builder.end_object(precision.value());
  }
  in.report.vertices += 3 * in.report.faces;
  return builder.finish(Axis::z, in.warnings.left_out());
}

Scene read_stl_binary(const ModelReading& in) {
  const auto& [bytes, name, folder] = in.file;
  if (bytes.size() < kPreambleBytes) {
    throw InputError(name, "binary STL of " + std::to_string(bytes.size()) + " bytes, shorter than its header of 84");
  }
  const std::size_t declared = stl_triangle_count(bytes), room = (bytes.size() - kPreambleBytes) / kTriangleBytes;
  // Programs that write triangles as they make them may leave the count at 0, or at the largest number.
  const std::size_t n = declared == 0 || declared == kCountNotWritten ? room : declared;
  if (n > room) {
    throw InputError(name, "binary STL declares " + std::to_string(n) + " triangles, which need " +
                               std::to_string(kPreambleBytes + kTriangleBytes * n) + " bytes, but the file has " +
                               std::to_string(bytes.size()));
  }
  const std::size_t extra = bytes.size() - kPreambleBytes - kTriangleBytes * n;
  if (extra > 0) in.warnings.leave_out("bytes behind the triangles", extra);
  SceneBuilder builder(name, in.report);
  builder.begin_object("");
  const std::span<Point3> vertices = builder.add_vertices(3 * n);
  std::vector<std::uint32_t> corners = large_vector<std::uint32_t>(3 * n);
  const FoundCoordinates found = read_triangles(bytes, vertices, corners);
  if (n != declared || extra > 0) check_damage(found, vertices, declared, name);
  if (found.not_finite < n) {
    throw InputError(
        name, "triangle " + std::to_string(found.not_finite) + " of " + std::to_string(n) + ": a coordinate is not finite");
  }
  builder.add_triangles(std::move(corners));
  builder.end_object(half_ulp_float32(found.largest));
  in.report.vertices += 3 * n;
  return builder.finish(Axis::z, in.warnings.left_out());
}

}  // namespace ligne
