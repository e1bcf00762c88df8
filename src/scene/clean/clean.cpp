// Order of work: weld the vertices, replace each corner's vertex by the first one at its position, drop the faces that
// collapse, cut the faces that are not planar, drop the unused vertices. Scenes of triangles alone, which are the large
// ones, are cleaned in place by code of their own. A scene that needs no change is not copied.

#include "scene/clean/clean.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/compact.hpp"
#include "scene/clean/cut_nonplanar.hpp"

namespace ligne {
namespace {

constexpr char kNoArea[] = "non-planar faces without an area dropped";
constexpr char kHole[] = "holes with fewer than three distinct vertices dropped";
constexpr char kNotPlanar[] = "non-planar faces cut into triangles";
constexpr char kCrossing[] =
    "faces whose sides cross, or with holes outside, opaque only in part: lines behind them may show";

/// Dropped faces, by cause.
struct Dropped {
  std::size_t degenerate = 0, not_finite = 0, no_area = 0;
  bool any() const { return degenerate + not_finite + no_area != 0; }
  friend Dropped operator+(Dropped a, const Dropped& b) {
    return {a.degenerate + b.degenerate, a.not_finite + b.not_finite, a.no_area + b.no_area};
  }
};

[[maybe_unused]] bool ranges_cover(const Scene& scene) {
  std::uint32_t vertex = 0, face = 0;
  for (const Object& o : scene.objects) {
    if (o.vertex_begin != vertex || o.face_begin != face || o.vertex_end < vertex || o.face_end < face) return false;
    vertex = o.vertex_end, face = o.face_end;
  }
  return vertex == scene.vertices.size() && face == scene.faces.size();
}

bool is_degenerate(const std::uint32_t* t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }
bool is_lost(const std::uint32_t* t) { return t[0] == kNone || t[1] == kNone || t[2] == kNone; }

/// Drops collapsed triangles; keeps the order of the others.
void drop_triangles(Scene& scene, Warnings& warnings) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  const std::size_t n = scene.faces.size();
  std::vector<std::uint32_t> first_new(n + 1);
  std::uint32_t kept = 0;
  for (std::size_t f = 0; f < n; ++f) {
    first_new[f] = kept;
    const std::uint32_t* t = &corners[3 * f];
    if (is_lost(t) || is_degenerate(t)) continue;
    std::copy_n(t, 3, &corners[3 * kept]);
    if (!scene.corner_flags.empty()) std::copy_n(&scene.corner_flags[3 * f], 3, &scene.corner_flags[3 * kept]);
    if (!scene.face_material.empty()) scene.face_material[kept] = scene.face_material[f];
    if (!scene.face_source.empty()) scene.face_source[kept] = scene.face_source[f];
    ++kept;
  }
  first_new[n] = kept;
  scene.faces.truncate_triangles(kept);
  if (!scene.corner_flags.empty()) scene.corner_flags.resize(3 * std::size_t{kept});
  if (!scene.face_material.empty()) scene.face_material.resize(kept);
  if (!scene.face_source.empty()) scene.face_source.resize(kept);
  renumber_faces(scene, first_new, warnings);
}

Dropped clean_triangles(Scene& scene, const Weld& weld, Warnings& warnings) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  const bool same = weld.changes_nothing();
  const Dropped dropped =
      parallel_reduce(scene.faces.size(), kShortWorkBlock, Dropped{}, [&](std::size_t begin, std::size_t end) {
        Dropped sum;
        for (std::size_t f = begin; f != end; ++f) {
          std::uint32_t* t = &corners[3 * f];
          if (!same) {
            for (int k = 0; k < 3; ++k) t[k] = weld.first[t[k]];
          }
          if (is_lost(t)) {
            ++sum.not_finite;
          } else if (is_degenerate(t)) {
            ++sum.degenerate;
          }
        }
        return sum;
      });
  if (dropped.any()) drop_triangles(scene, warnings);
  return dropped;
}

/// Rewrites the faces of a scene, one after the other.
class PolygonCleaner {
 public:
  PolygonCleaner(Scene& scene, const Weld& weld, Warnings& warnings) : scene_(scene), weld_(weld), warnings_(warnings) {}

  Dropped run() {
    const std::size_t n = scene_.faces.size();
    std::vector<std::uint32_t> first_new(n + 1);
    faces_.reserve_corners(scene_.faces.corners().size());
    for (const Object& object : scene_.objects) {
      for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
        first_new[f] = static_cast<std::uint32_t>(faces_.size());
        if (read_face(f)) write_face(f, object.precision);
      }
    }
    first_new[n] = static_cast<std::uint32_t>(faces_.size());
    scene_.faces = std::move(faces_);
    scene_.corner_flags = std::move(flags_);
    if (!scene_.face_material.empty()) scene_.face_material = std::move(material_);
    if (!scene_.face_source.empty()) scene_.face_source = std::move(source_);
    renumber_faces(scene_, first_new, warnings_);
    return dropped_;
  }

 private:
  /// Reads the welded contours of face f into face_; false if the face is to be dropped.
  bool read_face(std::uint32_t f) {
    face_.corners.clear(), face_.flags.clear(), face_.contour_end.clear();
    for (std::size_t c = 0; c < scene_.faces.contour_count(f); ++c) {
      const std::size_t begin = face_.corners.size();
      if (!read_contour(f, c)) {
        ++dropped_.not_finite;
        return false;
      }
      if (has_three_distinct(std::span(face_.corners).subspan(begin))) {
        face_.contour_end.push_back(static_cast<std::uint32_t>(face_.corners.size()));
      } else if (c == 0) {
        ++dropped_.degenerate;
        return false;
      } else {
        warnings_.add(kHole);
        face_.corners.resize(begin);
        face_.flags.resize(begin);
      }
    }
    return true;
  }

  bool read_contour(std::uint32_t f, std::size_t c) {
    const std::span<const std::uint32_t> contour = std::as_const(scene_.faces).contour(f, c);
    const std::size_t first = scene_.faces.corner_index(f, c);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t v = weld_.first[contour[k]];
      if (v == kNone) return false;
      // In a run of equal corners the last one stays: its edge leads on.
      if (v == weld_.first[contour[k + 1 == contour.size() ? 0 : k + 1]]) continue;
      face_.corners.push_back(v);
      face_.flags.push_back(scene_.corner_flags.empty() ? 0 : scene_.corner_flags[first + k]);
    }
    return true;
  }

  static bool has_three_distinct(std::span<const std::uint32_t> contour) {
    if (contour.size() < 3) return false;
    // Corners in a row differ, so the first two are distinct.
    return std::any_of(contour.begin() + 2, contour.end(),
                       [&](std::uint32_t v) { return v != contour[0] && v != contour[1]; });
  }

  void write_face(std::uint32_t f, double precision) {
    if (is_planar(scene_.vertices, face_, precision)) {
      add(face_);
      if (!is_covered(scene_.vertices, face_)) warnings_.add(kCrossing);
    } else {
      bool covered = true;
      const std::vector<CutTriangle> triangles = cut_into_triangles(scene_.vertices, face_, covered);
      if (!covered) warnings_.add(kCrossing);
      if (triangles.empty()) {
        ++dropped_.no_area;
        return;
      }
      warnings_.add(kNotPlanar);
      for (const CutTriangle& t : triangles) {
        faces_.add_triangle(t.vertices[0], t.vertices[1], t.vertices[2]);
        add_flags(t.flags);
      }
    }
    if (!scene_.face_material.empty()) material_.resize(faces_.size(), scene_.face_material[f]);
    if (!scene_.face_source.empty()) source_.resize(faces_.size(), scene_.face_source[f]);
  }

  void add(const DetachedFace& face) {
    std::size_t begin = 0;
    for (const std::uint32_t end : face.contour_end) {
      const auto contour = std::span(face.corners).subspan(begin, end - begin);
      if (begin == 0) {
        faces_.add_face(contour);
      } else {
        faces_.add_hole(contour);
      }
      begin = end;
    }
    add_flags(face.flags);
  }

  /// Adds flags of corners. The list of flags stays empty until a corner has one.
  void add_flags(std::span<const std::uint8_t> flags) {
    if (flags_.empty() && std::all_of(flags.begin(), flags.end(), [](std::uint8_t f) { return f == 0; })) return;
    flags_.resize(faces_.corners().size() - flags.size(), 0);
    flags_.insert(flags_.end(), flags.begin(), flags.end());
  }

  Scene& scene_;
  const Weld& weld_;
  Warnings& warnings_;
  DetachedFace face_;
  PolygonFaces faces_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> material_, source_;
  Dropped dropped_;
};

}  // namespace

void make_single_object(Scene& scene) {
  if (!scene.objects.empty() || (scene.vertices.empty() && scene.faces.empty())) return;
  scene.objects.push_back({.vertex_end = static_cast<std::uint32_t>(scene.vertices.size()),
                           .face_end = static_cast<std::uint32_t>(scene.faces.size())});
}

void finish_scene(Scene& scene, Warnings& warnings, std::optional<Weld> known) {
  make_single_object(scene);
  assert(ranges_cover(scene));
  Dropped dropped;
  {
    const Weld weld = known ? *std::move(known) : weld_vertices(scene);
    dropped =
        scene.faces.all_triangles() ? clean_triangles(scene, weld, warnings) : PolygonCleaner(scene, weld, warnings).run();
  }
  warnings.add(kDegenerateFaces, dropped.degenerate);
  warnings.add(kFacesNotFinite, dropped.not_finite);
  warnings.add(kNoArea, dropped.no_area);
  drop_unused_vertices(scene);
}

}  // namespace ligne
