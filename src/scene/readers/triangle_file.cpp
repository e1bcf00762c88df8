#include "scene/readers/triangle_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/polygon_faces.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/load_bytes.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {
namespace {

constexpr std::size_t kStlHead = 84, kStlRecord = 50, kStlNormal = 12, kStlCorner = 12;
/// Number of records that one task checks.
constexpr std::size_t kCheckedBlock = 65'536;

/// The lowest index of a bad record in a block, and the largest coordinate.
struct Checked {
  std::size_t wrong = SIZE_MAX;
  double largest = 0;
  friend Checked operator+(const Checked& a, const Checked& b) {
    return {std::min(a.wrong, b.wrong), std::max(a.largest, b.largest)};
  }
};

}  // namespace

std::unique_ptr<TriangleFile> TriangleFile::open(const std::filesystem::path& path, std::string& why) {
  std::optional<MappedFile> mapped = MappedFile::open(path);
  if (!mapped) {
    why = "it is not a regular file, which can be read several times";
    return nullptr;
  }
  const ModelFormat format = detect_format(mapped->bytes(), path.extension().string(), path.string());
  std::unique_ptr<TriangleFile> file(new TriangleFile(std::move(*mapped), path.string()));
  file->format_ = format;
  if (format == ModelFormat::stl_binary) {
    if (file->find_stl()) return file;
    why = "its size differs from its header";
  } else if (format == ModelFormat::ply) {
    why = file->find_ply();
    if (why.empty()) return file;
  } else {
    why = "it is neither binary STL nor binary PLY";
  }
  return nullptr;
}

bool TriangleFile::find_stl() {
  if (!is_binary_stl(file_.bytes())) return false;
  triangles_ = {kStlHead, kStlRecord, stl_triangle_count(file_.bytes())};
  vertices_.count = 3 * triangles_.count;
  return triangles_.count > 0;
}

std::string TriangleFile::find_ply() {
  const PlyHeader header = read_ply_header(file_.bytes(), name_);
  if (header.encoding == PlyEncoding::ascii) return "it is neither binary STL nor binary PLY";
  order_ = header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  std::size_t begin = header.bytes;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    Records* const records = element.name == "vertex" ? &vertices_ : element.name == "face" ? &triangles_ : nullptr;
    std::string why = element.name == "vertex" ? take_vertices(element, begin)
                      : element.name == "face" ? take_faces(element, begin)
                                               : "it has elements beside vertices and faces";
    if (!why.empty()) return why;
    if (element.count > file_.bytes().size() / records->size) return "its size differs from its header";
    records->count = static_cast<std::size_t>(element.count);
    begin = records->end();
  }
  if (vertices_.count == 0 || triangles_.count == 0) return "it has no faces";
  return begin == file_.bytes().size() ? "" : "its size differs from its header";
}

std::string TriangleFile::take_vertices(const PlyElement& element, std::size_t begin) {
  const std::size_t axes[3] = {element.find({"x"}), element.find({"y"}), element.find({"z"})};
  is_float32_ = false;
  std::size_t offset = 0, found = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list) return "its vertices have lists";
    const auto axis = static_cast<std::size_t>(std::find(axes, axes + 3, p) - axes);
    if (axis < 3) {
      coordinates_[axis] = {property.type, offset};
      is_float32_ = is_float32_ || property.type == NumberType::float32;
      ++found;
    }
    offset += byte_size(property.type);
  }
  vertices_ = {begin, offset, 0};
  return found == 3 ? "" : "its vertices have no coordinates";
}

std::string TriangleFile::take_faces(const PlyElement& element, std::size_t begin) {
  const std::size_t indices = element.find({"vertex_indices", "vertex_index"});
  std::size_t offset = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list != (p == indices)) return "its faces have lists other than vertex_indices";
    if (p == indices) {
      list_ = offset;
      count_type_ = property.count_type;
      index_type_ = property.type;
      offset += byte_size(count_type_) + 3 * byte_size(index_type_);
    } else {
      offset += byte_size(property.type);
    }
  }
  triangles_ = {begin, offset, 0};
  if (is_float(index_type_)) return "its vertex indices are not integers";
  return indices < element.properties.size() ? "" : "its faces have no corners";
}

ReadReport TriangleFile::report() const {
  ReadReport report;
  report.format = format_;
  report.faces = report.triangles = triangles_.count;
  report.vertices = vertices_.count;
  report.files = {name_};
  return report;
}

Point3 TriangleFile::vertex(std::size_t i) const {
  const std::byte* const data = file_.bytes().data();
  Point3 p;
  if (format_ == ModelFormat::stl_binary) {
    const std::byte* at = data + kStlHead + kStlRecord * (i / 3) + kStlNormal + kStlCorner * (i % 3);
    for (int k = 0; k < 3; ++k, at += sizeof(float)) p[k] = load_bytes<float>(at, std::endian::little);
    return p;
  }
  const std::byte* const at = data + vertices_.begin + vertices_.size * i;
  for (int k = 0; k < 3; ++k) {
    const Coordinate& c = coordinates_[k];
    p[k] = c.type == NumberType::float32 ? load_bytes<float>(at + c.offset, order_)
                                         : load_number(at + c.offset, c.type, order_);
  }
  return p;
}

std::uint32_t TriangleFile::corner(std::size_t triangle, std::size_t k) const {
  const std::byte* const list = file_.bytes().data() + triangles_.begin + triangles_.size * triangle + list_;
  const double index = load_number(list + byte_size(count_type_) + k * byte_size(index_type_), index_type_, order_);
  return index >= 0 && index < double{kNone} ? static_cast<std::uint32_t>(index) : kNone;
}

bool TriangleFile::check() {
  if (3 * triangles_.count >= kNone || vertices_.count >= kNone) {
    throw InputError(name_, "holds more than 4294967294 vertices or corners");
  }
  check_vertices();
  return format_ == ModelFormat::stl_binary || check_faces();
}

void TriangleFile::check_vertices() {
  const Checked found = parallel_reduce(vertices_.count, kCheckedBlock, Checked{}, [&](std::size_t begin, std::size_t end) {
    Checked block;
    std::vector<Point3> positions(end - begin);
    read_vertices(begin, end, positions.data());
    forget_vertices(begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      const Point3& p = positions[i - begin];
      const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && size <= kLargestCoordinate;
      if (!finite) block.wrong = std::min(block.wrong, i);
      block.largest = std::max(block.largest, finite ? size : 0);
    }
    return block;
  });
  if (found.wrong != SIZE_MAX) {
    const Point3 p = vertex(found.wrong);
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    const bool is_stl = format_ == ModelFormat::stl_binary;
    const std::size_t number = is_stl && !finite ? found.wrong / 3 : found.wrong;
    const std::size_t count = is_stl && !finite ? triangles_.count : vertices_.count;
    throw InputError(
        name_, (is_stl && !finite ? "triangle " : "vertex ") + std::to_string(number) + " of " + std::to_string(count) +
                   (finite ? ": a coordinate is beyond 1.6e60, too large to compute with" : ": a coordinate is not finite"));
  }
  precision_ = is_float32_ ? half_ulp_float32(found.largest) : half_ulp_double(found.largest);
}

bool TriangleFile::check_faces() const {
  const Checked found = parallel_reduce(triangles_.count, kCheckedBlock, Checked{}, [&](std::size_t begin, std::size_t end) {
    Checked block;
    for (std::size_t t = begin; t < end && block.largest == 0; ++t) {
      const std::byte* const list = file_.bytes().data() + triangles_.begin + triangles_.size * t + list_;
      if (load_number(list, count_type_, order_) != 3) block.largest = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        if (corner(t, k) >= vertices_.count) block.wrong = std::min(block.wrong, t);
      }
    }
    forget_triangles(begin, end);
    return block;
  });
  if (found.largest > 0) return false;  // the records have other sizes, so none of these numbers is valid
  if (found.wrong == SIZE_MAX) return true;
  std::size_t k = 0;
  while (corner(found.wrong, k) < vertices_.count) ++k;
  throw InputError(name_, "face " + std::to_string(found.wrong) + " names vertex " + std::to_string(corner(found.wrong, k)) +
                              " of " + std::to_string(vertices_.count));
}

void TriangleFile::read_triangles(std::size_t begin, std::size_t end, Point3* corners) const {
  if (format_ == ModelFormat::stl_binary) return read_vertices(3 * begin, 3 * end, corners);
  for (std::size_t t = begin; t < end; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = corner(t, k);
      // The file may have changed since check().
      if (v >= vertices_.count) throw InputError(name_, "changes while it is read");
      *corners++ = vertex(v);
    }
  }
}

void TriangleFile::read_vertices(std::size_t begin, std::size_t end, Point3* positions) const {
  for (std::size_t i = begin; i < end; ++i) *positions++ = vertex(i);
}

void TriangleFile::forget_triangles(std::size_t begin, std::size_t end) const {
  file_.forget(triangles_.begin + triangles_.size * begin, triangles_.begin + triangles_.size * end);
  // Neighbouring faces of a PLY share vertices, so these are forgotten only from time to time.
  constexpr std::size_t kReportInterval = std::size_t{1} << 20;
  if (format_ == ModelFormat::ply && begin / kReportInterval != end / kReportInterval)
    file_.forget(vertices_.begin, vertices_.end());
}

void TriangleFile::forget_vertices(std::size_t begin, std::size_t end) const {
  if (format_ == ModelFormat::stl_binary) return forget_triangles(begin / 3, end / 3);
  file_.forget(vertices_.begin + vertices_.size * begin, vertices_.begin + vertices_.size * end);
}

}  // namespace ligne
