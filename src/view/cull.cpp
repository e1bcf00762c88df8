#include "view/cull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/disjoint_sets.hpp"
#include "view/edge_classes.hpp"

namespace ligne {
namespace {

/// A sum of n triple products is wrong by less than (n + kRoundingsOfProduct) times this part of the sum of their sizes. The
/// error of the differences that go into the products is one of the coordinates, and counted there.
constexpr double kHalfUlp = 0x1p-53;
constexpr double kRoundingsOfProduct = 12;

/// Six times the volume within a shell, by the divergence theorem, with what it takes to tell its sign.
struct Volume {
  double six_times = 0;
  double terms_size = 0;  ///< sum of the sizes of the terms before they cancel
  double area = 0;        ///< twice the surface
  std::size_t terms = 0;

  /// +1, -1, or 0 when rounding or the coordinates' own error (`precision`, model units) could turn it.
  int sign(double precision) const {
    const double rounding = kHalfUlp * (kRoundingsOfProduct + static_cast<double>(terms)) * terms_size;
    const double moved = 3 * precision * area;  // every point of the surface moved along its normal
    if (std::abs(six_times) <= rounding + moved) return 0;
    return six_times > 0 ? 1 : -1;
  }
};

/// Half the diagonal of the near plane's window, and its distance: nothing farther from the eye is cut open in view.
double reach_of_near_plane(const View& view) {
  const double half_height = std::tan(view.camera.fov_degrees * 3.14159265358979323846 / 360);
  return view.near_distance * glm::length(Point3{half_height * view.camera.aspect, half_height, 1});
}

class Finder {
 public:
  Finder(const Scene& scene, const Topology& topology, const View& view)
      : scene_(scene),
        topology_(topology),
        view_(view),
        facings_(face_facings(scene, view.camera)),
        shells_(scene.faces.size()) {}

  BackFaces find() {
    BackFaces result;
    result.culled.assign(scene_.faces.size(), 0);
    for (const Object& object : scene_.objects) {
      if (object.face_begin == object.face_end) continue;
      ++result.objects;
      if (!viewed_from_outside(object) || !solid(object) || !orient(object)) {
        ++result.kept_objects;
        continue;
      }
      for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
        const int outward = volumes_[shells_.find(f) - object.face_begin].sign(object.precision);
        result.culled[f] = facings_[f] * outward < 0;
        result.faces += result.culled[f];
      }
    }
    return result;
  }

 private:
  bool viewed_from_outside(const Object& object) const {
    if (!view_.camera.perspective) return true;
    const auto first = scene_.vertices.begin() + object.vertex_begin, last = scene_.vertices.begin() + object.vertex_end;
    Point3 low = *first, high = *first;
    for (auto v = first; v != last; ++v) {
      low = glm::min(low, *v);
      high = glm::max(high, *v);
    }
    const Point3 eye = view_.camera.eye;
    return glm::length(eye - glm::clamp(eye, low, high)) > reach_of_near_plane(view_);
  }

  /// Closed and consistently wound; finds its shells. Edges come in the order of their first vertices, so those of an object
  /// follow each other.
  bool solid(const Object& object) {
    const auto& edges = topology_.edges;
    const auto before = [](const Edge& edge, std::uint32_t vertex) { return edge.v0 < vertex; };
    const auto first = std::lower_bound(edges.begin(), edges.end(), object.vertex_begin, before);
    for (auto edge = first; edge != edges.end() && edge->v0 < object.vertex_end; ++edge) {
      const std::uint8_t flags = topology_.edge_flags[static_cast<std::size_t>(edge - edges.begin())];
      if (edge->face1 == kNone || (flags & (kEdgeManyFaces | kEdgeUnlikeWound))) return false;
      shells_.join(edge->face0, edge->face1);
    }
    return true;
  }

  /// Measures the volumes of the object's shells; false when the sign of one is not certain.
  bool orient(const Object& object) {
    const Point3 origin = scene_.vertices[object.vertex_begin];
    volumes_.assign(object.face_end - object.face_begin, {});
    const auto& triangles = topology_.triangles;
    const auto before = [](const Triangle& triangle, std::uint32_t face) { return triangle.face < face; };
    const auto first = std::lower_bound(triangles.begin(), triangles.end(), object.face_begin, before);
    for (auto t = first; t != triangles.end() && t->face < object.face_end; ++t) {
      const Point3 a = scene_.vertices[t->v[0]] - origin, b = scene_.vertices[t->v[1]] - origin,
                   c = scene_.vertices[t->v[2]] - origin;
      Volume& volume = volumes_[shells_.find(t->face) - object.face_begin];
      volume.six_times += glm::dot(a, glm::cross(b, c));
      volume.terms_size += glm::length(a) * glm::length(b) * glm::length(c);
      volume.area += glm::length(glm::cross(b - a, c - a));
      ++volume.terms;
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      if (shells_.find(f) == f && volumes_[f - object.face_begin].sign(object.precision) == 0) return false;
    }
    return true;
  }

  const Scene& scene_;
  const Topology& topology_;
  const View& view_;
  std::vector<std::int8_t> facings_;
  DisjointSets shells_;
  std::vector<Volume> volumes_;  ///< of the object at hand, at the place of the shell's lowest face
};

}  // namespace

BackFaces find_back_faces(const Scene& scene, const Topology& topology, const View& view) {
  return Finder(scene, topology, view).find();
}

void cull(ProjectedScene& projected, const BackFaces& back_faces) {
  const auto culled = [&](std::uint32_t face) { return face != kNone && back_faces.culled[face]; };
  std::erase_if(projected.triangles, [&](const Triangle& t) { return culled(t.face); });
  std::size_t kept = 0;
  for (std::size_t e = 0; e < projected.edges.size(); ++e) {
    const ProjectedEdge edge = projected.edges[e];
    if (culled(edge.face0) && culled(edge.face1)) continue;
    projected.edges[kept] = edge;
    if (!projected.edge_parts.empty()) projected.edge_parts[kept] = projected.edge_parts[e];
    ++kept;
  }
  projected.edges.resize(kept);
  if (!projected.edge_parts.empty()) projected.edge_parts.resize(kept);
}

}  // namespace ligne
