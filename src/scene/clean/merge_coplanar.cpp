// Phases, per object:
//   1. Each edge of exactly two faces that traverse it in opposite directions pairs their corners.
//   2. Regions grow over such edges from the largest face to smaller ones, over faces of one material that have the
//      same orientation and whose corners lie in the plane of the first face (planarity_tolerance()). Since distances
//      are always measured from the first face, a gently curved surface is not flattened step by step.
//   3. Edges with both sides in one region cancel; the others are walked into contours (merge_contours.hpp).
//   4. Vertices in the middle of straight runs are removed (straighten.cpp).
// A region of one face keeps it unchanged. If faces outside the plane stand on an edge inside a region, the region
// loses that edge too, and only they keep it.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "scene/clean/clean.hpp"
#include "scene/clean/compact.hpp"
#include "scene/clean/merge_contours.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

class ObjectMerger {
 public:
  ObjectMerger(const Scene& scene, const Object& object) : scene_(scene), object_(object) {
    const std::uint32_t n = object.face_end - object.face_begin;
    first_corner_ = n == 0 ? 0 : scene.faces.corner_index(object.face_begin, 0);
    for (std::uint32_t f = 0; f < n; ++f) {
      for (std::size_t c = 0; c < scene.faces.contour_count(object.face_begin + f); ++c) {
        const auto begin = static_cast<std::uint32_t>(face_of_.size());
        const auto end = begin + static_cast<std::uint32_t>(contour(f, c).size());
        face_of_.resize(end, f);
        for (std::uint32_t k = begin; k < end; ++k) next_.push_back(k + 1 == end ? begin : k + 1);
      }
    }
  }

  /// Makes the new faces. new_face(f) then tells where face f went.
  std::vector<MergedFace> run() {
    pair_corners();
    grow_regions();
    std::vector<MergedFace> faces;
    const std::size_t n = regions_.size();
    std::vector<std::uint32_t> first_of_region(n, kNone);
    begin_.assign(n, 0), end_.assign(n, 0);
    for (std::uint32_t f = 0; f < region_of_.size(); ++f) {
      const std::uint32_t r = region_of_[f];
      if (first_of_region[r] != kNone) continue;
      first_of_region[r] = f;
      begin_[r] = static_cast<std::uint32_t>(faces.size());
      for (MergedFace& face : regions_[r].faces.size() == 1 ? keep(f) : merge(regions_[r])) {
        face.material = material(f);
        face.source = source(f);
        faces.push_back(std::move(face));
      }
      end_[r] = static_cast<std::uint32_t>(faces.size());
    }
    straighten(scene_.vertices, object_, faces);
    return faces;
  }

  /// The new face of this object that contains the point of old face f, or kNone if nothing of f remains.
  std::uint32_t new_face(std::uint32_t f, const std::vector<MergedFace>& faces, const Point3& point) const {
    const std::uint32_t r = region_of_[f - object_.face_begin];
    if (begin_[r] == end_[r]) return kNone;
    const PlaneAxes axes = PlaneAxes::facing(regions_[r].plane.normal);
    for (std::uint32_t k = begin_[r]; k < end_[r]; ++k) {
      if (is_inside(scene_.vertices, axes, faces[k].contours[0], axes(point))) return k;
    }
    return begin_[r];
  }

 private:
  struct Region {
    SpanningPlane plane;  ///< plane of its first face, with the normal of that face's orientation
    std::vector<std::uint32_t> faces;
  };

  // Faces and corners are numbered from the first one of the object.
  std::span<const std::uint32_t> contour(std::uint32_t f, std::size_t c) const {
    return scene_.faces.contour(object_.face_begin + f, c);
  }
  std::uint32_t vertex(std::uint32_t corner) const { return scene_.faces.corners()[first_corner_ + corner]; }
  std::uint32_t begin_of(std::uint32_t f) const {
    return static_cast<std::uint32_t>(scene_.faces.corner_index(object_.face_begin + f, 0) - first_corner_);
  }
  std::uint32_t end_of(std::uint32_t f) const {
    return f + 1 == object_.face_end - object_.face_begin ? static_cast<std::uint32_t>(next_.size()) : begin_of(f + 1);
  }
  std::uint8_t flags(std::uint32_t corner) const {
    return scene_.corner_flags.empty() ? 0 : scene_.corner_flags[first_corner_ + corner];
  }
  std::uint32_t source(std::uint32_t f) const {
    return scene_.face_source.empty() ? 0 : scene_.face_source[object_.face_begin + f];
  }
  std::uint32_t material(std::uint32_t f) const {
    return scene_.face_material.empty() ? 0 : scene_.face_material[object_.face_begin + f];
  }

  void pair_corners() {
    const std::uint32_t n = static_cast<std::uint32_t>(next_.size());
    const auto ends = [&](std::uint32_t k) { return std::minmax({vertex(k), vertex(next_[k])}); };
    // Corners by the lower vertex of their edge, sorted by the higher one.
    IndexLists by_vertex = numbers_by_key(object_.vertex_end - object_.vertex_begin, n,
                                          [&](std::uint32_t k) { return ends(k).first - object_.vertex_begin; });
    mate_.assign(n, kNone);
    for (std::size_t v = 0; v < by_vertex.size(); ++v) {
      const std::span<std::uint32_t> corners = by_vertex[v];
      std::ranges::sort(corners, {}, [&](std::uint32_t k) { return std::pair(ends(k).second, k); });
      for (std::size_t i = 0, same = 0; i < corners.size(); i = same) {
        while (same < corners.size() && ends(corners[same]).second == ends(corners[i]).second) ++same;
        const std::uint32_t a = corners[i], b = corners[same - 1];
        if (same - i == 2 && vertex(a) == vertex(next_[b]) && vertex(a) != vertex(b)) mate_[a] = b, mate_[b] = a;
      }
    }
  }

  void grow_regions() {
    const std::uint32_t n = object_.face_end - object_.face_begin;
    std::vector<double> area(n);
    normal_.resize(n);
    for (std::uint32_t f = 0; f < n; ++f) {
      normal_[f] = area_vector(scene_.vertices, contour(f, 0));
      area[f] = glm::dot(normal_[f], normal_[f]);
    }
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    region_of_.assign(n, kNone);
    for (const std::uint32_t f : order) {
      if (region_of_[f] == kNone) grow_region(f);
    }
  }

  void grow_region(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(regions_.size());
    Region& region = regions_.emplace_back();
    std::vector<Point3> points;
    for (std::uint32_t k = begin_of(first); k < end_of(first); ++k) points.push_back(scene_.vertices[vertex(k)]);
    region.plane = spanning_plane(points);
    if (glm::dot(region.plane.normal, normal_[first]) < 0) region.plane.normal = -region.plane.normal;
    region.faces.push_back(first);
    region_of_[first] = number;
    if (region.plane.normal == Point3(0)) return;
    for (std::size_t i = 0; i < region.faces.size(); ++i) {
      const std::uint32_t f = region.faces[i];
      for (std::uint32_t k = begin_of(f); k < end_of(f); ++k) {
        if (mate_[k] == kNone) continue;
        const std::uint32_t g = face_of_[mate_[k]];
        if (region_of_[g] != kNone || material(g) != material(first) || !lies_in(region.plane, g)) continue;
        region_of_[g] = number;
        region.faces.push_back(g);
      }
    }
  }

  bool lies_in(const SpanningPlane& plane, std::uint32_t f) const {
    if (glm::dot(plane.normal, normal_[f]) < 0) return false;
    for (std::uint32_t k = begin_of(f); k < end_of(f); ++k) {
      const Point3& p = scene_.vertices[vertex(k)];
      const double span = std::max(plane.span, glm::distance(p, plane.origin));
      if (std::abs(plane.distance(p)) > planarity_tolerance(object_.precision, span)) return false;
    }
    return true;
  }

  std::vector<MergedFace> keep(std::uint32_t f) const {
    MergedFace face;
    std::uint32_t corner = begin_of(f);
    for (std::size_t c = 0; c < scene_.faces.contour_count(object_.face_begin + f); ++c) {
      Contour& out = face.contours.emplace_back();
      for (const std::uint32_t v : contour(f, c)) {
        out.corners.push_back(v);
        out.flags.push_back(flags(corner++));
      }
    }
    return {std::move(face)};
  }

  std::vector<MergedFace> merge(const Region& region) const {
    const std::uint32_t number = region_of_[region.faces[0]];
    std::vector<BoundaryEdge> edges;
    for (const std::uint32_t f : region.faces) {
      for (std::uint32_t k = begin_of(f); k < end_of(f); ++k) {
        if (mate_[k] != kNone && region_of_[face_of_[mate_[k]]] == number) continue;
        edges.push_back({vertex(k), vertex(next_[k]), flags(k)});
      }
    }
    return faces_of_boundary(scene_.vertices, PlaneAxes::facing(region.plane.normal), std::move(edges));
  }

  const Scene& scene_;
  const Object& object_;
  std::size_t first_corner_ = 0;
  std::vector<std::uint32_t> face_of_, next_, mate_;  ///< per corner
  std::vector<Point3> normal_;                        ///< per face: area vector of its outer contour
  std::vector<std::uint32_t> region_of_;              ///< per face
  std::vector<Region> regions_;
  std::vector<std::uint32_t> begin_, end_;  ///< per region: its new faces
};

/// Writes the faces of the new scene, one after the other.
class FaceWriter {
 public:
  void add(const MergedFace& face) {
    for (std::size_t c = 0; c < face.contours.size(); ++c) {
      const Contour& contour = face.contours[c];
      if (c == 0) {
        faces_.add_face(contour.corners);
      } else {
        faces_.add_hole(contour.corners);
      }
      flags_.insert(flags_.end(), contour.flags.begin(), contour.flags.end());
    }
    material_.push_back(face.material);
    source_.push_back(face.source);
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(faces_.size()); }

  void replace_faces_of(Scene& scene) {
    scene.faces = std::move(faces_);
    if (!scene.face_material.empty()) scene.face_material = std::move(material_);
    if (!scene.face_source.empty()) scene.face_source = std::move(source_);
    if (!scene.corner_flags.empty()) scene.corner_flags = std::move(flags_);
  }

 private:
  PolygonFaces faces_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> material_, source_;
};

}  // namespace

void merge_coplanar_faces(Scene& scene) {
  FaceWriter writer;
  std::vector<Object> objects = scene.objects;
  std::vector<Detail> details = scene.details;
  for (std::size_t o = 0; o < objects.size(); ++o) {
    const Object& object = scene.objects[o];
    ObjectMerger merger(scene, object);
    const std::vector<MergedFace> faces = merger.run();
    objects[o].face_begin = writer.size();
    for (const MergedFace& face : faces) writer.add(face);
    objects[o].face_end = writer.size();
    for (std::size_t d = 0; d < details.size(); ++d) {
      const Detail& old = scene.details[d];
      if (old.face < object.face_begin || old.face >= object.face_end) continue;
      const std::uint32_t moved = merger.new_face(old.face, faces, old.contour.empty() ? Point3(0) : old.contour[0]);
      details[d].face = moved == kNone ? kNone : objects[o].face_begin + moved;
    }
  }
  std::erase_if(details, [](const Detail& detail) { return detail.face == kNone; });
  writer.replace_faces_of(scene);
  scene.objects = std::move(objects);
  scene.details = std::move(details);
  drop_unused_vertices(scene);
}

}  // namespace ligne
