// Every index of the next level follows from those of the mesh, so nothing is searched and all loops run in parallel.
//
//   Catmull and Clark: the quad at corner k         Loop: the triangles of triangle f
//
//    previous                                            v2
//       |                                                |  .
//    middle ---- point of the face                       m2 -- m1        m_k: middle of side k,
//       |   k        |                                   |  .  |  .      from v_k to v_(k+1)
//      v_k ----- middle ----- next                       v0 -- m0 -- v1

#include <algorithm>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {
namespace {

/// Sharpness decreases by 1 with each level [DeRoseEtAl1998].
float decayed(float sharpness) { return std::max(sharpness - 1, 0.0f); }

class Refiner {
 public:
  Refiner(const SubdivisionMesh& mesh, bool loop, bool last) : mesh_(mesh), loop_(loop), last_(last) {}

  SubdivisionMesh run() {
    vertex_count_ = static_cast<std::uint32_t>(mesh_.points.size());
    edge_count_ = static_cast<std::uint32_t>(mesh_.edges.size());
    const std::size_t sides = mesh_.corners.size(), corners = 4 * sides;
    child_.face_size = loop_ ? 3 : 4;
    child_.corners.resize(corners);
    child_.corner_edge.resize(corners);
    child_.vertex_sharpness.assign(vertex_count_ + edge_count_ + (loop_ ? 0 : mesh_.face_count()), 0);
    parallel_each(vertex_count_, [&](std::uint32_t v) { child_.vertex_sharpness[v] = decayed(mesh_.vertex_sharpness[v]); });
    const std::size_t edges = 2 * mesh_.edges.size() + (last_ ? 0 : sides);
    child_.edges.resize(edges);
    child_.edge_sharpness.assign(edges, 0);
    child_.edge_flags.assign(edges, 0);
    parallel_each(edge_count_, [&](std::uint32_t e) { halve(e); });
    if (loop_) {
      parallel_each(sides / 3, [&](std::uint32_t f) { split_triangle(f); });
    } else {
      parallel_each(sides, [&](std::uint32_t k) { add_quad(k); });
    }
    return std::move(child_);
  }

 private:
  std::uint32_t middle(std::uint32_t e) const { return vertex_count_ + e; }
  std::uint32_t inner(std::uint32_t corner) const { return 2 * edge_count_ + corner; }
  std::uint32_t half(std::uint32_t e, std::uint32_t v) const { return 2 * e + (mesh_.edges[e].ends[0] == v ? 0 : 1); }

  /// The corner at which the half of a side at vertex v begins, in its face of the next level.
  std::uint32_t half_side(std::uint32_t side, std::uint32_t v) const {
    const bool begins = mesh_.corners[side] == v;
    if (!loop_) return begins ? 4 * side : 4 * mesh_.next(side) + 3;
    const std::uint32_t f = side / 3, k = begins ? side % 3 : (side + 1) % 3;
    return 12 * f + 3 * k + (begins ? 0 : 2);
  }

  void halve(std::uint32_t e) {
    const SubdivisionEdge& edge = mesh_.edges[e];
    for (std::uint32_t h = 0; h < 2; ++h) {
      SubdivisionEdge& made = child_.edges[2 * e + h];
      made.ends = {edge.ends[h], middle(e)};
      for (int s = 0; s < 2; ++s) {
        if (edge.sides[s] != kNone) made.sides[s] = half_side(edge.sides[s], edge.ends[h]);
      }
      child_.edge_sharpness[2 * e + h] = decayed(mesh_.edge_sharpness[e]);
      child_.edge_flags[2 * e + h] = mesh_.edge_flags[e];
    }
  }

  void add_quad(std::uint32_t k) {
    const std::uint32_t previous = mesh_.previous(k), v = mesh_.corners[k];
    const std::uint32_t e = mesh_.corner_edge[k], before = mesh_.corner_edge[previous];
    const std::uint32_t center = vertex_count_ + edge_count_ + mesh_.face_of(k);
    std::uint32_t* const corners = &child_.corners[4 * std::size_t{k}];
    corners[0] = v, corners[1] = middle(e), corners[2] = center, corners[3] = middle(before);
    std::uint32_t* const edges = &child_.corner_edge[4 * std::size_t{k}];
    edges[0] = half(e, v), edges[1] = inner(k), edges[2] = inner(previous), edges[3] = half(before, v);
    if (!last_) child_.edges[inner(k)] = {{middle(e), center}, {4 * k + 1, 4 * mesh_.next(k) + 2}};
  }

  void split_triangle(std::uint32_t f) {
    std::uint32_t* const corners = &child_.corners[12 * std::size_t{f}];
    std::uint32_t* const edges = &child_.corner_edge[12 * std::size_t{f}];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh_.corners[3 * f + k];
      const std::uint32_t e = mesh_.corner_edge[3 * f + k], before = mesh_.corner_edge[3 * f + (k + 2) % 3];
      corners[3 * k] = v, corners[3 * k + 1] = middle(e), corners[3 * k + 2] = middle(before);
      edges[3 * k] = half(e, v), edges[3 * k + 1] = inner(3 * f + k), edges[3 * k + 2] = half(before, v);
      corners[9 + k] = middle(e);
      edges[9 + k] = inner(3 * f + (k + 1) % 3);
      if (last_) continue;
      child_.edges[inner(3 * f + k)] = {{middle(e), middle(before)}, {12 * f + 3 * k + 1, 12 * f + 9 + (k + 2) % 3}};
    }
  }

  const SubdivisionMesh& mesh_;
  bool loop_, last_;
  std::uint32_t vertex_count_ = 0, edge_count_ = 0;
  SubdivisionMesh child_;
};

}  // namespace

SubdivisionMesh refine(const SubdivisionMesh& mesh, SubdivisionScheme scheme, bool last) {
  return Refiner(mesh, scheme == SubdivisionScheme::loop, last).run();
}

}  // namespace ligne
