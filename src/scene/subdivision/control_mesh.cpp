#include "scene/subdivision/control_mesh.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "base/no_index.hpp"
#include "scene/clean/cut_nonplanar.hpp"

namespace ligne {
namespace {

class MeshBuilder {
 public:
  MeshBuilder(const Scene& scene, const Object& object, std::span<const std::uint32_t> first, const CreaseTags& tags,
              bool triangles)
      : scene_(scene), object_(object), first_(first), tags_(tags), triangles_(triangles) {}

  ControlMesh run() {
    vertex_tags_.assign(object_.vertex_end - object_.vertex_begin, 0);
    made_.mesh.face_begin.push_back(0);
    for (std::uint32_t f = object_.face_begin; f < object_.face_end; ++f) {
      if (read_face(f)) write_face(f);
    }
    number_vertices();
    sharpen_ends_of_faces();
    connect_edges(made_.mesh, sides_);
    return std::move(made_);
  }

 private:
  /// Reads the contours of a face, with welded vertices; false if the face is left out.
  bool read_face(std::uint32_t f) {
    face_ = {};
    sharpness_.clear();
    for (std::size_t c = 0; c < scene_.faces.contour_count(f); ++c) {
      const std::size_t begin = face_.corners.size();
      if (!read_contour(f, c)) {
        ++made_.left_out.not_finite;
        return false;
      }
      const auto contour = std::span(face_.corners).subspan(begin);
      const bool distinct = contour.size() >= 3 && std::any_of(contour.begin() + 2, contour.end(), [&](std::uint32_t v) {
                              return v != contour[0] && v != contour[1];
                            });
      if (distinct) {
        face_.contour_end.push_back(static_cast<std::uint32_t>(face_.corners.size()));
      } else if (c == 0) {
        ++made_.left_out.degenerate;
        return false;
      } else {
        face_.corners.resize(begin);
        face_.flags.resize(begin);
        sharpness_.resize(begin);
      }
    }
    return true;
  }

  /// Reads a contour; false if a vertex is not finite. In a run of equal corners the last one stays.
  bool read_contour(std::uint32_t f, std::size_t c) {
    const std::span<const std::uint32_t> contour = std::as_const(scene_.faces).contour(f, c);
    const std::size_t corner = scene_.faces.corner_index(f, c);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t here = contour[k], next = contour[k + 1 == contour.size() ? 0 : k + 1];
      if (first_[here] == kNone) return false;
      if (first_[here] == first_[next]) continue;
      const std::uint8_t flags = scene_.corner_flags.empty() ? 0 : scene_.corner_flags[corner + k];
      face_.corners.push_back(first_[here]);
      face_.flags.push_back(flags & ~(kCornerSmooth | kCornerSharp));
      const float tagged = tags_.of_edge(here, next);
      made_.tagged += tagged > 0;
      sharpness_.push_back(flags & kCornerSharp ? kAlwaysSharp : tagged);
      float& vertex_tag = vertex_tags_[first_[here] - object_.vertex_begin];
      vertex_tag = std::max(vertex_tag, tags_.of_vertex(here));
    }
    return true;
  }

  void write_face(std::uint32_t f) {
    if (face_.contour_end.size() == 1 && !(triangles_ && face_.corners.size() > 3)) {
      add_face(f, face_.corners, face_.flags, sharpness_);
      return;
    }
    begin_at_lowest();
    bool covered = true;
    std::vector<CutTriangle> cut;
    const bool with_holes = face_.contour_end.size() > 1;
    if (with_holes || face_.corners.size() > 4) cut = cut_into_triangles(scene_.vertices, face_, covered);
    if (cut.empty()) cut = fan();
    made_.left_out.degenerate += cut.empty();
    sort_sides();
    for (const CutTriangle& t : cut) {
      std::array<float, 3> sharpness{};
      for (std::size_t k = 0; k < 3; ++k) sharpness[k] = sharpness_between(t.vertices[k], t.vertices[(k + 1) % 3]);
      add_face(f, t.vertices, t.flags, sharpness);
    }
  }

  /// Makes every contour begin at its lowest vertex, so that triangulation does not depend on the first corner in the
  /// file.
  void begin_at_lowest() {
    std::size_t begin = 0;
    for (const std::uint32_t end : face_.contour_end) {
      const auto corners = std::span(face_.corners).subspan(begin, end - begin);
      const auto lowest = std::ranges::min_element(corners) - corners.begin();
      const auto turn = [&](auto& values) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
        std::rotate(first, first + lowest, values.begin() + end);
      };
      turn(face_.corners), turn(face_.flags), turn(sharpness_);
      begin = end;
    }
  }

  /// Triangles from one corner of the outer contour. Quads of control meshes may be bent so much that no projection
  /// shows their shape, so a quad is cut along its shorter diagonal.
  std::vector<CutTriangle> fan() const {
    const std::uint32_t n = face_.contour_end[0];
    const auto corner = [&](std::uint32_t k) { return face_.corners[k % n]; };
    const auto flags = [&](std::uint32_t k) { return face_.flags[k % n]; };
    const auto length = [&](std::uint32_t a, std::uint32_t b) {
      return glm::distance(scene_.vertices[corner(a)], scene_.vertices[corner(b)]);
    };
    const std::uint32_t from = n == 4 && length(1, 3) < kShorterDiagonal * length(0, 2);
    std::vector<CutTriangle> triangles;
    for (std::uint32_t k = from + 1; k + 1 < from + n; ++k) {
      if (corner(from) == corner(k) || corner(from) == corner(k + 1)) continue;
      triangles.push_back({{corner(from), corner(k), corner(k + 1)},
                           {k == from + 1 ? flags(from) : std::uint8_t{kCornerInner}, flags(k),
                            k + 2 == from + n ? flags(k + 1) : std::uint8_t{kCornerInner}}});
    }
    return triangles;
  }

  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  /// Collects the sharp sides of the face that was read, sorted by their vertices.
  void sort_sides() {
    sharp_sides_.clear();
    std::size_t begin = 0;
    for (const std::uint32_t end : face_.contour_end) {
      for (std::size_t k = begin; k < end; ++k) {
        const Ends ends = std::minmax(face_.corners[k], face_.corners[k + 1 == end ? begin : k + 1]);
        if (sharpness_[k] > 0) sharp_sides_.emplace_back(ends, sharpness_[k]);
      }
      begin = end;
    }
    std::ranges::sort(sharp_sides_);
  }

  float sharpness_between(std::uint32_t a, std::uint32_t b) const {
    const Ends ends = std::minmax(a, b);
    const auto at = std::ranges::lower_bound(sharp_sides_, ends, {}, [](const auto& side) { return side.first; });
    return at != sharp_sides_.end() && at->first == ends ? at->second : 0;
  }

  void add_face(std::uint32_t f, std::span<const std::uint32_t> corners, std::span<const std::uint8_t> flags,
                std::span<const float> sharpness) {
    SubdivisionMesh& mesh = made_.mesh;
    for (const std::uint32_t v : corners) {
      mesh.corners.push_back(v);
      mesh.corner_face.push_back(static_cast<std::uint32_t>(made_.face_source.size()));
    }
    mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    sides_.flags.insert(sides_.flags.end(), flags.begin(), flags.end());
    sides_.sharpness.insert(sides_.sharpness.end(), sharpness.begin(), sharpness.end());
    made_.face_source.push_back(f);
  }

  /// Replaces scene vertices by mesh vertices, in the same order.
  void number_vertices() {
    SubdivisionMesh& mesh = made_.mesh;
    const std::uint32_t begin = object_.vertex_begin;
    std::vector<std::uint32_t> number(vertex_tags_.size(), kNone);
    for (const std::uint32_t v : mesh.corners) number[v - begin] = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      if (number[v] == kNone) continue;
      number[v] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.push_back(scene_.vertices[begin + v]);
      mesh.vertex_sharpness.push_back(vertex_tags_[v]);
    }
    for (std::uint32_t& v : mesh.corners) v = number[v - begin];
  }

  /// Makes every vertex of a single face sharp: as the corner of a sheet, it stays in place. Triangles cut from one
  /// polygon are one face.
  void sharpen_ends_of_faces() {
    SubdivisionMesh& mesh = made_.mesh;
    std::vector<std::uint32_t> face_at(mesh.points.size(), kNone);
    std::vector<std::uint8_t> has_more(mesh.points.size(), 0);
    for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
      const std::uint32_t v = mesh.corners[k], f = made_.face_source[mesh.corner_face[k]];
      if (face_at[v] == kNone) face_at[v] = f;
      has_more[v] |= face_at[v] != f;
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (!has_more[v]) mesh.vertex_sharpness[v] = kAlwaysSharp;
    }
  }

  const Scene& scene_;
  const Object& object_;
  std::span<const std::uint32_t> first_;
  const CreaseTags& tags_;
  bool triangles_;
  ControlMesh made_;
  SideTags sides_;
  DetachedFace face_;                                ///< the face read last
  std::vector<float> sharpness_;                     ///< of the sides of face_
  std::vector<std::pair<Ends, float>> sharp_sides_;  ///< the sharp sides of face_, sorted
  std::vector<float> vertex_tags_;                   ///< sharpness per vertex of the object
};

}  // namespace

ControlMesh make_control_mesh(const Scene& scene, const Object& object, std::span<const std::uint32_t> first,
                              const CreaseTags& tags, bool triangles) {
  return MeshBuilder(scene, object, first, tags, triangles).run();
}

}  // namespace ligne
