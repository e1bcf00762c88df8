#include "view/edge_classes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel_each.hpp"
#include "base/prefetch.hpp"
#include "scene/model/face_shape.hpp"
#include "scene/model/planarity.hpp"
#include "view/clip.hpp"

namespace ligne {
namespace {

/// Largest angle by which float32 coordinates turn the normals of small faces; an edge at exactly the crease angle is
/// no crease.
constexpr double kCreaseSlackDegrees = 0.01;

/// Mark of a face without area, until mend_flat_faces().
constexpr std::int8_t kFlat = 2;

/// Orientation of the faces.
struct FaceSides {
  std::vector<std::int8_t> facing;  ///< 1 towards the eye, -1 away from it, 0 seen edge on
  std::vector<glm::vec3> normal;    ///< unit length; zero for a face without area; empty if not needed
  bool any_flat = false;
};

/// The sides of faces after their corners were rounded to the page.
class PageSides {
 public:
  explicit PageSides(const View& view) : view_(view), lattice_(page_lattice(view)), volume_(face_volume(view, lattice_)) {}

  /// The side that a face turns to the viewer: 1, -1, or 0 if its outer contour has no area. Nothing if it is clipped.
  std::optional<int> of(const Scene& scene, std::uint32_t face) const {
    const std::span<const std::uint32_t> contour = scene.faces.contour(face, 0);
    LatticePoint first, last;
    double area = 0;
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const HomogeneousPoint p = to_homogeneous(view_, scene.vertices[contour[k]]);
      if (!volume_.contains(p)) return {};
      const LatticePoint next = lattice_.snap({p.x / p.w, p.y / p.w});
      if (k == 0) first = next;
      area += orientation(first, last, next);
      last = next;
    }
    return area == 0 ? 0 : area < 0 ? 1 : -1;
  }

 private:
  const View& view_;
  Lattice lattice_;
  ClipVolume volume_;
};

/// `sure`: facings of triangles that are known, or empty.
FaceSides face_sides(const Scene& scene, const View& view, bool with_normals, std::vector<std::int8_t> sure = {}) {
  FaceSides sides;
  const Camera& camera = view.camera;
  const std::size_t n = scene.faces.size();
  const bool has_sure = !sure.empty() && !with_normals;
  sides.facing = has_sure ? std::move(sure) : large_vector<std::int8_t>(n);
  if (with_normals) sides.normal = large_vector<glm::vec3>(n);
  std::atomic<bool> any_flat{false};
  const double forward_length = glm::length(camera.forward);
  const PageSides page(view);
  const auto set = [&](std::size_t f, const Point3& normal, const Point3& on_face) {
    if (with_normals) sides.normal[f] = normal;
    const Point3 sight = camera.perspective ? on_face - camera.eye : camera.forward;
    const double length = camera.perspective ? glm::length(sight) : forward_length;
    const double d = glm::dot(normal, sight);
    int facing = std::abs(d) <= kEdgeOnSine * length ? 0 : d < 0 ? 1 : -1;
    if (facing != 0 && std::abs(d) <= kNearlyEdgeOnSine * length) {
      if (page.of(scene, static_cast<std::uint32_t>(f)).value_or(facing) != facing) facing = 0;
    }
    sides.facing[f] = static_cast<std::int8_t>(facing);
    if (normal != Point3{0, 0, 0}) return;
    sides.facing[f] = kFlat;
    any_flat.store(true, std::memory_order_relaxed);
  };
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  const bool all_triangles = scene.faces.all_triangles();
  parallel_each(n, [&](std::size_t f) {
    if (has_sure && sides.facing[f] != 0) return;
    if (all_triangles) {
      if (!has_sure) prefetch_corners(scene.vertices, corners, f);
      const Point3& a = scene.vertices[corners[3 * f]];
      const Point3 &b = scene.vertices[corners[3 * f + 1]], &c = scene.vertices[corners[3 * f + 2]];
      set(f, triangle_normal(a, b, c), a);
    } else {
      const auto face = static_cast<std::uint32_t>(f);
      set(f, face_normal(scene, face), scene.vertices[scene.faces.contour(face, 0)[0]]);
    }
  });
  sides.any_flat = any_flat;
  return sides;
}

/// Whether an edge lies between a face that faces the eye and one that does not.
bool turns_away(const FaceSides& sides, const Topology& topology, std::size_t e) {
  const Edge& edge = topology.edges[e];
  if (edge.face1 == kNone || (topology.edge_flags[e] & kEdgeManyFaces)) return false;
  const int turn = topology.edge_flags[e] & kEdgeUnlikeWound ? -1 : 1;
  return sides.facing[edge.face0] != sides.facing[edge.face1] * turn;
}

/// The side that the faces around a sliver face, other slivers left out; 0 if they differ.
int side_around(const Scene& scene, const Topology& topology, const FaceSides& sides, std::uint32_t sliver) {
  const auto corners = scene.faces.contour(sliver, 0);
  int side = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Edge* edge = find_edge(topology, {corners[k], corners[(k + 1) % corners.size()]});
    if (!edge || edge->face1 == kNone) continue;
    const std::uint16_t flags = topology.edge_flags[static_cast<std::size_t>(edge - topology.edges.data())];
    const std::uint32_t beyond = edge->face0 == sliver ? edge->face1 : edge->face0;
    if ((flags & kEdgeManyFaces) || is_sliver_face(scene, beyond)) continue;
    const int there = sides.facing[beyond] * (flags & kEdgeUnlikeWound ? -1 : 1);
    if (there == 0 || there == -side) return 0;
    side = there;
  }
  return side;
}

/// Turns slivers amid faces of one side to that side: the direction of their own is a matter of chance, and would be an
/// outline in the midst of a plane. `turned`: the edges at which faces turn away. Returns whether there were such slivers.
bool turn_slivers(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> turned, FaceSides& sides) {
  bool any = false;
  for (const std::uint32_t e : turned) {
    for (const std::uint32_t f : {topology.edges[e].face0, topology.edges[e].face1}) {
      if (!is_sliver_face(scene, f)) continue;
      const int side = side_around(scene, topology, sides, f);
      if (side == 0 || side == sides.facing[f]) continue;
      sides.facing[f] = static_cast<std::int8_t>(side);
      any = true;
    }
  }
  return any;
}

/// Gives faces without area the side of their neighbour across their longest edge.
void mend_flat_faces(const Scene& scene, const Topology& topology, FaceSides& sides) {
  if (!sides.any_flat) return;
  std::vector<std::uint8_t> flat(sides.facing.size());
  std::transform(sides.facing.begin(), sides.facing.end(), flat.begin(), [](std::int8_t f) { return f == kFlat; });
  // None of these neighbours is flat, so their order does not matter.
  for (const auto& [face, neighbour] : longest_neighbours(scene, topology, flat, FlatNeighbours::passed_over)) {
    const int turn = neighbour.turned ? -1 : 1;
    sides.facing[face] = static_cast<std::int8_t>(turn * sides.facing[neighbour.face]);
    if (!sides.normal.empty()) sides.normal[face] = static_cast<float>(turn) * sides.normal[neighbour.face];
  }
  std::ranges::replace(sides.facing, kFlat, std::int8_t{0});
}

/// Finds the line classes of edges.
class EdgeClassifier {
 public:
  /// `creases`: as in classify_edges(). `sides` may change between two calls of all().
  EdgeClassifier(const Topology& topology, const FaceSides& sides, double crease_degrees,
                 const std::vector<std::uint8_t>* creases)
      : topology_(topology), sides_(sides), creases_(creases), crease_cosine_(cosine_of(crease_degrees)) {}

  /// Sets the classes of all edges, and returns the edges at which faces turn away, ascending.
  std::vector<std::uint32_t> all(std::vector<LineClass>& classes) const {
    return indices_of_blocks(classes.size(), [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& turned) {
      for (std::size_t e = begin; e < end; ++e) {
        if (creases_ && is_plain(e)) {
          classes[e] = LineClass::mesh;
          continue;
        }
        if (!creases_) {
          prefetch_faces(sides_.facing, topology_.edges, e);
          prefetch_faces(sides_.normal, topology_.edges, e);
        }
        const bool turns = turns_away(sides_, topology_, e);
        if (turns) turned.push_back(static_cast<std::uint32_t>(e));
        classes[e] = class_of(e, turns);
      }
    });
  }

 private:
  static float cosine_of(double crease_degrees) {
    const double degree = 3.14159265358979323846 / 180;
    return static_cast<float>(std::cos(std::min(180.0, crease_degrees + kCreaseSlackDegrees) * degree));
  }

  /// Whether an edge is surely no line; most edges of large meshes are plain.
  bool is_plain(std::size_t e) const {
    if ((topology_.edge_flags[e] | (*creases_)[e]) != 0) return false;
    const Edge& edge = topology_.edges[e];
    return edge.face1 != kNone && sides_.facing[edge.face0] == sides_.facing[edge.face1];
  }

  LineClass class_of(std::size_t e, bool turns) const {
    const Edge& edge = topology_.edges[e];
    const std::uint16_t flags = topology_.edge_flags[e];
    if (flags & kEdgeCrossing) return LineClass::intersection;
    if ((flags & kEdgeContour) && edge.face1 != kNone) return LineClass::contour;
    if (flags & kEdgeCurve) return LineClass::horizon;
    if (edge.face1 == kNone) return LineClass::border;
    if (flags & kEdgeManyFaces) {
      // Only two of its faces are stored, and which ones depends on the file, so they can not decide on an outline.
      const std::uint8_t line = creases_ ? (*creases_)[e] : kCreaseLine;
      return line == kCreaseLine ? LineClass::crease : line == kFoldLine ? LineClass::outline : LineClass::mesh;
    }
    if (turns) return LineClass::outline;
    if (creases_) {
      const std::uint8_t line = (*creases_)[e];
      return line == kCreaseLine ? LineClass::crease : line == kTangentLine ? LineClass::tangent : LineClass::mesh;
    }
    if (flags & (kEdgeFileHidden | kEdgeInner)) return LineClass::mesh;
    const float turn = flags & kEdgeUnlikeWound ? -1 : 1;
    const float cosine = glm::dot(sides_.normal[edge.face0], sides_.normal[edge.face1]) * turn;
    return cosine < crease_cosine_ ? LineClass::crease : LineClass::mesh;
  }

  const Topology& topology_;
  const FaceSides& sides_;
  const std::vector<std::uint8_t>* creases_;
  float crease_cosine_;
};

}  // namespace

std::vector<std::int8_t> face_facings(const Scene& scene, const View& view) {
  FaceSides sides = face_sides(scene, view, false);
  if (sides.any_flat) std::ranges::replace(sides.facing, kFlat, std::int8_t{0});
  return std::move(sides.facing);
}

std::vector<LineClass> classify_edges(const Scene& scene, const Topology& topology, const View& view, double crease_degrees,
                                      const std::vector<std::uint8_t>* creases, std::vector<std::int8_t> sure) {
  FaceSides sides = face_sides(scene, view, creases == nullptr, std::move(sure));
  mend_flat_faces(scene, topology, sides);
  const EdgeClassifier classify(topology, sides, crease_degrees, creases);
  std::vector<LineClass> classes(topology.edges.size());
  const std::vector<std::uint32_t> turned = classify.all(classes);
  if (creases && turn_slivers(scene, topology, turned, sides)) classify.all(classes);
  return classes;
}

}  // namespace ligne
