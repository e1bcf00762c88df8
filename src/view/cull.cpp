#include "view/cull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "scene/model/self_contact.hpp"
#include "view/edge_classes.hpp"

namespace ligne {
namespace {

/// Half a unit in the last place: a sum of n triple products is wrong by less than (n + kRoundingsOfProduct) times this
/// part of the sum of their sizes. The error of the differences in the products counts as an error of the coordinates.
constexpr double kHalfUlp = 0x1p-53;
constexpr double kRoundingsOfProduct = 12;

/// Six times the volume of a shell, by the divergence theorem, and the bounds that decide its sign.
struct Volume {
  double six_times = 0;
  double terms_size = 0;  ///< sum of the sizes of the terms, without cancellation
  double area = 0;        ///< twice the surface
  std::size_t terms = 0;

  /// +1, -1, or 0 if rounding or the error of the coordinates (`precision`, model units) could reverse the sign.
  int sign(double precision) const {
    const double rounding = kHalfUlp * (kRoundingsOfProduct + static_cast<double>(terms)) * terms_size;
    const double moved = 3 * precision * area;  // every point of the surface moved along its normal
    if (std::abs(six_times) <= rounding + moved) return 0;
    return six_times > 0 ? 1 : -1;
  }
};

/// Distance from the eye to the corners of the near plane's window: the near plane cuts nothing farther away.
double reach_of_near_plane(const View& view) {
  const double half_height = std::tan(view.camera.fov_degrees * 3.14159265358979323846 / 360);
  return view.near_distance * glm::length(Point3{half_height * view.camera.aspect, half_height, 1});
}

class Finder {
 public:
  Finder(const Scene& scene, const Topology& topology, const View& view)
      : scene_(scene), topology_(topology), view_(view), facings_(face_facings(scene, view)), sets_(scene.faces.size()) {}

  BackFaces find() {
    BackFaces result;
    result.culled.assign(scene_.faces.size(), 0);
    shell_of_face_.assign(scene_.faces.size(), kNone);
    std::vector<const Object*> solids;
    for (const Object& object : scene_.objects) {
      if (object.face_begin == object.face_end) continue;
      ++result.objects;
      if (viewed_from_outside(object) && solid(object) && orient(object)) {
        solids.push_back(&object);
      } else {
        ++result.kept_objects;
      }
    }
    keep_shells_that_show_more();
    for (const Object* object : solids) {
      bool keeps = false;
      for (std::uint32_t f = object->face_begin; f < object->face_end; ++f) {
        const Shell& shell = shells_[shell_of_face_[f]];
        keeps = keeps || shell.kept;
        result.culled[f] = !shell.kept && facings_[f] * shell.outward < 0;
        result.faces += result.culled[f];
      }
      result.kept_objects += keeps;
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

  /// Whether the object is closed and consistently wound; finds its shells. Edges are sorted by their first vertices,
  /// so those of an object are consecutive.
  bool solid(const Object& object) {
    const auto& edges = topology_.edges;
    const auto before = [](const Edge& edge, std::uint32_t vertex) { return edge.v0 < vertex; };
    const auto first = std::lower_bound(edges.begin(), edges.end(), object.vertex_begin, before);
    for (auto edge = first; edge != edges.end() && edge->v0 < object.vertex_end; ++edge) {
      const std::uint16_t flags = topology_.edge_flags[static_cast<std::size_t>(edge - edges.begin())];
      if (edge->face1 == kNone || (flags & (kEdgeManyFaces | kEdgeUnlikeWound))) return false;
      sets_.join(edge->face0, edge->face1);
    }
    return true;
  }

  /// Measures the volumes of the object's shells and numbers them; false if the sign of one is uncertain.
  bool orient(const Object& object) {
    const Point3 origin = scene_.vertices[object.vertex_begin];
    volumes_.assign(object.face_end - object.face_begin, {});
    const auto& triangles = topology_.triangles;
    const auto before = [](const Triangle& triangle, std::uint32_t face) { return triangle.face < face; };
    const auto first = std::lower_bound(triangles.begin(), triangles.end(), object.face_begin, before);
    for (auto t = first; t != triangles.end() && t->face < object.face_end; ++t) {
      const Point3 a = scene_.vertices[t->v[0]] - origin, b = scene_.vertices[t->v[1]] - origin,
                   c = scene_.vertices[t->v[2]] - origin;
      Volume& volume = volumes_[sets_.find(t->face) - object.face_begin];
      volume.six_times += glm::dot(a, glm::cross(b, c));
      volume.terms_size += glm::length(a) * glm::length(b) * glm::length(c);
      volume.area += glm::length(glm::cross(b - a, c - a));
      ++volume.terms;
    }
    const auto sign_of = [&](std::uint32_t face) { return volumes_[face - object.face_begin].sign(object.precision); };
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      if (sets_.find(f) == f && sign_of(f) == 0) return false;
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      const std::uint32_t lowest = sets_.find(f);
      if (lowest == f) {
        shell_of_face_[f] = static_cast<std::uint32_t>(shells_.size());
        shells_.push_back({sign_of(f)});
      } else {
        shell_of_face_[f] = shell_of_face_[lowest];
      }
    }
    return true;
  }

  /// Marks the shells that are transparent, or touch or penetrate themselves.
  void keep_shells_that_show_more() {
    const std::vector<std::uint8_t> transparent = transparent_faces(scene_);
    for (std::size_t f = 0; f < transparent.size(); ++f) {
      if (transparent[f] && shell_of_face_[f] != kNone) shells_[shell_of_face_[f]].kept = true;
    }
    std::vector<std::uint32_t> shell_of_triangle;
    shell_of_triangle.reserve(topology_.triangles.size());
    for (const Triangle& t : topology_.triangles) {
      const std::uint32_t shell = shell_of_face_[t.face];
      shell_of_triangle.push_back(shell == kNone || shells_[shell].kept ? kNone : shell);
    }
    const std::vector<std::uint8_t> contacts = find_self_contacts(scene_.vertices, topology_.triangles, shell_of_triangle,
                                                                  static_cast<std::uint32_t>(shells_.size()));
    for (std::size_t s = 0; s < shells_.size(); ++s) shells_[s].kept = shells_[s].kept || contacts[s];
  }

  /// A shell of a solid.
  struct Shell {
    int outward;        ///< -1 if its faces are wound inwards
    bool kept = false;  ///< whether it keeps its back faces
  };

  const Scene& scene_;
  const Topology& topology_;
  const View& view_;
  std::vector<std::int8_t> facings_;
  DisjointSets sets_;                         ///< connected faces
  std::vector<Volume> volumes_;               ///< of the current object, at the index of the shell's lowest face
  std::vector<Shell> shells_;                 ///< of all solids
  std::vector<std::uint32_t> shell_of_face_;  ///< kNone: not on a solid
};

}  // namespace

BackFaces find_back_faces(const Scene& scene, const Topology& topology, const View& view) {
  return Finder(scene, topology, view).find();
}

void cull(ProjectedScene& projected, const BackFaces& back_faces) {
  if (back_faces.faces == 0) return;
  const auto culled = [&](std::uint32_t face) { return face != kNone && back_faces.culled[face]; };
  std::erase_if(projected.triangles, [&](const Triangle& t) { return culled(t.face); });
  projected.erase_edges([&](std::size_t e) { return culled(projected.edges[e].face0) && culled(projected.edges[e].face1); });
}

}  // namespace ligne
