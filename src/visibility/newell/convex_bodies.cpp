#include "visibility/newell/convex_bodies.hpp"

#include "base/disjoint_sets.hpp"
#include "base/index_lists.hpp"

namespace ligne::newell {
namespace {

/// Most products of vertices and triangles for which a set is tested for convexity: the test is quadratic. Tuned.
constexpr std::size_t kMostHeights = std::size_t{1} << 22;

}  // namespace

ConvexBodies::ConvexBodies(const Scene& scene, const ModelPieces& pieces, const Viewpoint& viewpoint)
    : body_(scene.faces.size(), kNone), is_front_(scene.faces.size(), 0) {
  DisjointSets sets(scene.vertices.size());
  for (const Triangle& t : pieces.triangles()) {
    sets.join(t.v[0], t.v[1]);
    sets.join(t.v[0], t.v[2]);
  }
  // Groups the triangles by set, in their order.
  const std::vector<Triangle>& triangles = pieces.triangles();
  const IndexLists shells =
      numbers_by_key(scene.vertices.size(), triangles.size(), [&](std::uint32_t t) { return sets.find(triangles[t].v[0]); });
  for (std::size_t root = 0; root < shells.size(); ++root) {
    const std::span<const std::uint32_t> shell = shells[root];
    const bool one_face = std::all_of(shell.begin(), shell.end(),
                                      [&](std::uint32_t t) { return triangles[t].face == triangles[shell[0]].face; });
    if (one_face) continue;
    if (scene.stated.has(StatedFact::convex)) {
      find_fronts(shell, pieces, viewpoint);
    } else if (!lies_on_one_side(shell, pieces, viewpoint)) {
      continue;
    }
    for (const std::uint32_t t : shell) {
      if (body_[triangles[t].face] == kNone) ++faces_;
      body_[triangles[t].face] = count_;
    }
    ++count_;
  }
}

void ConvexBodies::collect_vertices(std::span<const std::uint32_t> shell, const ModelPieces& pieces) {
  vertices_.clear();
  for (const std::uint32_t t : shell) {
    for (const std::uint32_t v : pieces.triangles()[t].v) vertices_.push_back(v);
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

/// Sets is_front_ for the faces of a convex body: the viewer and the body's centre lie on opposite sides of the plane.
void ConvexBodies::find_fronts(std::span<const std::uint32_t> shell, const ModelPieces& pieces, const Viewpoint& viewpoint) {
  collect_vertices(shell, pieces);
  Point3 middle{0, 0, 0};
  for (const std::uint32_t v : vertices_) middle += pieces.point(v) / double(vertices_.size());
  for (const std::uint32_t t : shell) {
    const ModelPlane plane = pieces.plane_of_triangle(t);
    if (plane.normal == Point3(0)) continue;
    ++heights_;
    is_front_[pieces.triangles()[t].face] = viewpoint.in_front_of(plane) != (plane.height(middle) > 0);
  }
}

/// True if all vertices of the set lie on one side of each of its planes; then sets is_front_. A non-planar face whose
/// triangles face the viewer differently makes the result false.
bool ConvexBodies::lies_on_one_side(std::span<const std::uint32_t> shell, const ModelPieces& pieces,
                                    const Viewpoint& viewpoint) {
  collect_vertices(shell, pieces);
  if (vertices_.size() * shell.size() > kMostHeights) return false;
  std::uint32_t last = kNone;
  for (const std::uint32_t t : shell) {
    const ModelPlane plane = pieces.plane_of_triangle(t);
    if (plane.normal == Point3(0)) continue;
    bool before = false, behind = false;
    for (const std::uint32_t v : vertices_) {
      ++heights_;
      const double height = plane.height(pieces.point(v));
      before |= height > pieces.tolerance();
      behind |= height < -pieces.tolerance();
      if (before && behind) return false;
    }
    const bool is_front = viewpoint.in_front_of(plane) != before;
    const std::uint32_t face = pieces.triangles()[t].face;
    if (face == last && is_front_[face] != is_front) return false;
    is_front_[face] = is_front;
    last = face;
  }
  return true;
}

}  // namespace ligne::newell
