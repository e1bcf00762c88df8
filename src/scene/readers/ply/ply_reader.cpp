// Our own reader: the libraries of Debian 12 were tried and none fits. assimp 5.2.5 stores coordinates as float32 even
// from double files, accepts indices of missing vertices and text that ends early, and adds 2.6 ms to the start of
// every run. CGAL's reader (LGPL) returns indices of missing vertices, and no line numbers. draco triangulates and
// stores float32. libigl is not packaged.
//
// Every element is read through one interface, item by item and value by value, from text or binary data. Counts in the
// header are trusted only as far as the data go. Vertices and triangles of binary files are read in blocks
// (ply_records.hpp), unless they contain a fault, which the slower way then locates.

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/ply/ply_data.hpp"
#include "scene/readers/ply/ply_header.hpp"
#include "scene/readers/ply/ply_records.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

template <typename Data>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Data data, const ModelReading& in)
      : header_(header), data_(std::move(data)), in_(in), builder_(in.file.name, in.report) {}

  Scene read() {
    check_elements();
    builder_.begin_object("");
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        leave_out(element);
    }
    data_.end();
    for (const std::string& remark : header_.remarks) in_.warnings.leave_out("header lines " + shown(remark));
    check_indices();
    if (in_.shading && !normals_.empty()) {
      for (const std::uint32_t v : std::as_const(builder_.scene().faces).corners()) {
        in_.shading->corner_normals.push_back(normals_[v]);
      }
    }
    Scene& points = builder_.scene();
    if (points.faces.empty() && !points.vertices.empty()) return std::move(points);
    builder_.end_object(precision());
    return builder_.finish(Axis::z, in_.warnings.left_out());
  }

 private:
  void check_elements() const {
    const auto has = [&](const char* element, std::initializer_list<const char*> names, bool list) {
      for (const PlyElement& e : header_.elements) {
        const std::size_t p = e.find(names);
        if (e.name == element && p < e.properties.size()) return e.properties[p].is_list == list;
      }
      return false;
    };
    for (const char* axis : {"x", "y", "z"}) {
      if (!has("vertex", {axis}, false))
        throw InputError(in_.file.name, "PLY header declares no " + std::string(axis) + " of vertices");
    }
    for (const char* element : {"face", "tristrips"}) {
      if (std::ranges::find(header_.elements, element, &PlyElement::name) == header_.elements.end()) continue;
      if (has(element, {"vertex_indices", "vertex_index"}, true)) continue;
      throw InputError(in_.file.name, std::string("PLY header declares no list vertex_indices of ") +
                                          (element == std::string_view("face") ? "faces" : element));
    }
  }

  std::uint64_t take_length(const PlyProperty& list) {
    const double length = data_.take(list.count_type).number;
    if (length < 0) throw data_.error("list of negative length");
    if (length > double{kNone}) throw data_.error("list is too long");  // in a text, whatever its type
    return static_cast<std::uint64_t>(length);
  }

  void pass_over(const PlyProperty& property) {
    data_.pass_over(property.type, property.is_list ? take_length(property) : 1);
  }

  void leave_out(const PlyElement& element) {
    in_.warnings.leave_out("items of element " + element.name, element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      data_.begin_item(element, i);
      for (const PlyProperty& property : element.properties) pass_over(property);
      data_.end_item();
    }
  }

  void read_vertices(const PlyElement& element) {
    const std::array axes{element.find({"x"}), element.find({"y"}), element.find({"z"})};
    const std::size_t none = element.properties.size();
    const std::array normal_axes{element.find({"nx"}), element.find({"ny"}), element.find({"nz"})};
    const bool with_normals = in_.shading && std::ranges::all_of(normal_axes, [&](std::size_t p) {
                                return p < none && !element.properties[p].is_list;
                              });
    for (const std::size_t p : axes) is_float32_ = is_float32_ || element.properties[p].type == NumberType::float32;
    in_.report.vertices += element.count;
    if (!with_normals && read_vertex_records(element, axes)) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      data_.begin_item(element, i);
      Point3 position, normal(0);
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const std::size_t axis = static_cast<std::size_t>(std::ranges::find(axes, p) - axes.begin());
        if (axis == 3) {
          const auto of_normal = static_cast<int>(std::ranges::find(normal_axes, p) - normal_axes.begin());
          if (with_normals && of_normal < 3)
            normal[of_normal] = data_.take(element.properties[p].type).number;
          else
            pass_over(element.properties[p]);
          continue;
        }
        const PlyValue value = data_.take(element.properties[p].type);
        if (!std::isfinite(value.number)) throw data_.error("a coordinate is not finite");
        position[static_cast<int>(axis)] = value.number;
        largest_ = std::max(largest_, std::abs(value.number));
        decimals_.add(value.digits, value.number);
      }
      data_.end_item();
      builder_.add_vertex(position);
      if (with_normals) normals_.push_back(packed_direction(normal));
    }
  }

  /// Reads a binary element without lists; false, with nothing read, if that is impossible.
  bool read_vertex_records(const PlyElement& element, const std::array<std::size_t, 3>& axes) {
    PlyTriples triples{{data_.rest(), byte_order()}, {}};
    const bool found = locate_triples(element, axes, triples).empty() && triples.records.take(element.count);
    std::vector<Point3>& vertices = builder_.scene().vertices;
    if (!found || vertices.size() + triples.records.count >= kNone) return false;
    const std::size_t before = vertices.size();
    vertices.resize(before + triples.records.count);
    const std::optional<double> largest = read_coordinates(triples, std::span(vertices).subspan(before));
    if (!largest) {
      vertices.resize(before);
      return false;
    }
    largest_ = std::max(largest_, *largest);
    data_.skip(triples.records);
    return true;
  }

  void read_faces(const PlyElement& element) {
    const std::size_t indices = corner_list(element);
    if (read_triangle_records(element, indices)) return;
    for_lists(element, indices, [this](const PlyProperty& list) {
      read_corners(list);
      builder_.add_face(face_);
    });
  }

  static std::size_t corner_list(const PlyElement& element) { return element.find({"vertex_indices", "vertex_index"}); }

  /// Calls read(list) for the list of each item, and passes over its other properties.
  template <class Read>
  void for_lists(const PlyElement& element, std::size_t list, const Read& read) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      data_.begin_item(element, i);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        p == list ? read(element.properties[p]) : pass_over(element.properties[p]);
      data_.end_item();
    }
  }

  /// Reads a binary element of triangles; false, with nothing read, if that is impossible.
  bool read_triangle_records(const PlyElement& element, std::size_t indices) {
    PlyTriangles triangles{{data_.rest(), byte_order()}, {}, {}};
    const bool found = locate_triangles(element, indices, triangles).empty() && triangles.records.take(element.count);
    const std::size_t count = triangles.records.count;
    if (!found || count == 0 || count >= kNone / 3 || !triangles.is_triangle(0)) return false;
    std::vector<std::uint32_t> corners(3 * count);
    if (!ligne::read_corners(triangles, corners)) return false;
    builder_.add_triangles(std::move(corners));
    data_.skip(triangles.records);
    return true;
  }

  std::endian byte_order() const {
    return header_.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  }

  void read_corners(const PlyProperty& list) {
    const std::uint64_t n = take_length(list);
    if (n < 3) throw data_.error("face with " + std::to_string(n) + " corners, needs 3 or more");
    face_.clear();
    for (std::uint64_t k = 0; k < n; ++k) face_.push_back(take_index(data_.take(list.type).number));
  }

  std::uint32_t take_index(double index) const {
    const bool is_index = index >= 0 && index < double{kNone} && index == std::trunc(index);
    if (!is_index) throw data_.error("corner of a face is not a vertex index");
    return static_cast<std::uint32_t>(index);
  }

  /// Reads strips of triangles, which follow each other in a list; -1 begins the next. Every second triangle is
  /// reversed.
  void read_strips(const PlyElement& element) {
    for_lists(element, corner_list(element), [this](const PlyProperty& list) { read_strip_list(list); });
  }

  void read_strip_list(const PlyProperty& list) {
    std::size_t length = 0;
    std::array<std::uint32_t, 3> last{};
    for (std::uint64_t n = take_length(list); n > 0; --n) {
      const double index = data_.take(list.type).number;
      if (index == -1 || index == double{kNone}) {
        length = 0;
        continue;
      }
      last = {last[1], last[2], take_index(index)};
      // Degenerate triangles join the strips.
      if (++length < 3 || last[0] == last[1] || last[1] == last[2] || last[0] == last[2]) continue;
      face_ = {last[0], last[1], last[2]};
      if (length % 2 == 0) std::swap(face_[0], face_[1]);
      builder_.add_face(face_);
    }
  }

  /// Checked at the end, since faces may precede their vertices.
  void check_indices() const {
    const Scene& scene = builder_.scene();
    const std::size_t n = scene.vertices.size();
    const auto is_beyond = [&](std::uint32_t v) { return v >= n; };
    const std::span<const std::uint32_t> corners = scene.faces.corners();
    const auto any_beyond = [&](std::size_t begin, std::size_t end) {
      return std::ranges::any_of(corners.subspan(begin, end - begin), is_beyond);
    };
    if (!parallel_reduce(corners.size(), kShortWorkBlock, false, any_beyond, std::logical_or<>{})) return;
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
      for (const std::uint32_t v : scene.faces.contour(f, 0)) {
        if (v >= n) {
          throw InputError(in_.file.name,
                           "face " + std::to_string(f) + " names vertex " + std::to_string(v) + " of " + std::to_string(n));
        }
      }
    }
  }

  double precision() const {
    if (header_.encoding == PlyEncoding::ascii) return decimals_.value();
    return is_float32_ ? half_ulp_float32(largest_) : half_ulp_double(largest_);
  }

  const PlyHeader& header_;
  Data data_;
  const ModelReading& in_;
  SceneBuilder builder_;
  std::vector<std::uint32_t> normals_;  ///< of the vertices, packed; empty if there are none
  bool is_float32_ = false;
  double largest_ = 0;
  DecimalPrecision decimals_;
  std::vector<std::uint32_t> face_;
};

}  // namespace

Scene read_ply(const ModelReading& in) {
  const std::string& name = in.file.name;
  const PlyHeader header = read_ply_header(in.file.bytes, name);
  const std::span<const std::byte> data = in.file.bytes.subspan(header.bytes);
  if (header.encoding == PlyEncoding::ascii)
    return PlyReader(header, PlyTextData(as_text(data, name), header.lines, name, in.warnings), in).read();
  const std::endian order = header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  return PlyReader(header, PlyBinaryData(data, order, name), in).read();
}

}  // namespace ligne
