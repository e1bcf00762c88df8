#include "scene/readers/triangle_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/format_readers.hpp"
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
  PlyRecords& records = triangles_.records;
  records = {file_.bytes().subspan(kStlHead), std::endian::little, stl_triangle_count(file_.bytes()), kStlRecord};
  vertices_.records = records;
  for (std::size_t k = 0; k < 3; ++k) vertices_.fields[k].offset = kStlNormal + k * sizeof(float);
  vertex_count_ = 3 * records.count;
  return records.count > 0;
}

std::string TriangleFile::find_ply() {
  const PlyHeader header = read_ply_header(file_.bytes(), name_);
  if (header.encoding == PlyEncoding::ascii) return "it is neither binary STL nor binary PLY";
  std::size_t begin = header.bytes;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    const bool is_face = element.name == "face";
    if (!is_face && element.name != "vertex") return "it has elements beside vertices and faces";
    std::string why =
        is_face ? locate_triangles(element, element.find({"vertex_indices", "vertex_index"}), triangles_)
                : locate_triples(element, {element.find({"x"}), element.find({"y"}), element.find({"z"})}, vertices_);
    if (!why.empty()) return why;
    if (is_face && is_float(triangles_.corners.type)) return "its vertex indices are not integers";
    PlyRecords& records = is_face ? triangles_.records : vertices_.records;
    records.data = file_.bytes().subspan(begin);
    if (header.encoding == PlyEncoding::big_endian) records.order = std::endian::big;
    if (!records.take(element.count)) return "its size differs from its header";
    begin += records.size * records.count;
  }
  vertex_count_ = vertices_.records.count;
  is_float32_ = std::ranges::count(vertices_.fields, NumberType::float32, &PlyField::type) > 0;
  if (vertex_count_ == 0 || triangle_count() == 0) return "it has no faces";
  return begin == file_.bytes().size() ? "" : "its size differs from its header";
}

ReadReport TriangleFile::report() const {
  ReadReport report;
  report.format = format_;
  report.faces = report.triangles = triangle_count();
  report.vertices = vertex_count_;
  report.files = {name_};
  return report;
}

Point3 TriangleFile::vertex(std::size_t i) const {
  return format_ == ModelFormat::stl_binary ? vertices_.point(i / 3, kStlCorner * (i % 3)) : vertices_.point(i);
}

bool TriangleFile::check() {
  if (3 * triangle_count() >= kNone || vertex_count_ >= kNone) {
    throw InputError(name_, "holds more than 4294967294 vertices or corners");
  }
  check_vertices();
  return format_ == ModelFormat::stl_binary || check_faces();
}

void TriangleFile::check_vertices() {
  const Checked found = parallel_reduce(vertex_count_, kCheckedBlock, Checked{}, [&](std::size_t begin, std::size_t end) {
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
    const std::size_t count = is_stl && !finite ? triangle_count() : vertex_count_;
    throw InputError(
        name_, (is_stl && !finite ? "triangle " : "vertex ") + std::to_string(number) + " of " + std::to_string(count) +
                   (finite ? ": a coordinate is beyond 1.6e60, too large to compute with" : ": a coordinate is not finite"));
  }
  precision_ = is_float32_ ? half_ulp_float32(found.largest) : half_ulp_double(found.largest);
}

bool TriangleFile::check_faces() const {
  const Checked found = parallel_reduce(triangle_count(), kCheckedBlock, Checked{}, [&](std::size_t begin, std::size_t end) {
    Checked block;
    for (std::size_t t = begin; t < end && block.largest == 0; ++t) {
      if (!triangles_.is_triangle(t)) block.largest = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangles_.corner(t, k) >= vertex_count_) block.wrong = std::min(block.wrong, t);
      }
    }
    forget_triangles(begin, end);
    return block;
  });
  if (found.largest > 0) return false;  // the records have other sizes, so none of these numbers is valid
  if (found.wrong == SIZE_MAX) return true;
  std::size_t k = 0;
  while (triangles_.corner(found.wrong, k) < vertex_count_) ++k;
  throw InputError(name_, "face " + std::to_string(found.wrong) + " names vertex " +
                              std::to_string(triangles_.corner(found.wrong, k)) + " of " + std::to_string(vertex_count_));
}

void TriangleFile::read_triangles(std::size_t begin, std::size_t end, Point3* corners) const {
  if (format_ == ModelFormat::stl_binary) return read_vertices(3 * begin, 3 * end, corners);
  for (std::size_t t = begin; t < end; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles_.corner(t, k);
      // The file may have changed since check().
      if (v >= vertex_count_) throw InputError(name_, "changes while it is read");
      *corners++ = vertex(v);
    }
  }
}

void TriangleFile::read_vertices(std::size_t begin, std::size_t end, Point3* positions) const {
  for (std::size_t i = begin; i < end; ++i) *positions++ = vertex(i);
}

void TriangleFile::forget(const PlyRecords& records, std::size_t begin, std::size_t end) const {
  const auto at = static_cast<std::size_t>(records.data.data() - file_.bytes().data());
  file_.forget(at + records.size * begin, at + records.size * end);
}

void TriangleFile::forget_triangles(std::size_t begin, std::size_t end) const {
  forget(triangles_.records, begin, end);
  // Neighbouring faces of a PLY share vertices, so these are forgotten only from time to time.
  constexpr std::size_t kReportInterval = std::size_t{1} << 20;
  if (format_ == ModelFormat::ply && begin / kReportInterval != end / kReportInterval)
    forget(vertices_.records, 0, vertex_count_);
}

void TriangleFile::forget_vertices(std::size_t begin, std::size_t end) const {
  if (format_ == ModelFormat::stl_binary) return forget_triangles(begin / 3, end / 3);
  forget(vertices_.records, begin, end);
}

}  // namespace ligne
