#include "visibility/painter/paint_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "base/index_lists.hpp"
#include "base/parallel.hpp"
#include "base/stop.hpp"
#include "visibility/polygons/facet_order.hpp"

namespace ligne::painter {
namespace {

/// A face on the page.
struct PaintedFace {
  std::vector<std::uint32_t> facets;
  double nearest = std::numeric_limits<double>::infinity(), farthest = -std::numeric_limits<double>::infinity();
  double mean = 0;
};

/// Two faces that overlap on the page, the lower number first.
struct Pair {
  std::uint32_t a = 0, b = 0;
  bool a_in_front = false, b_in_front = false;  ///< in front in some part of the overlap
  friend bool operator<(const Pair& p, const Pair& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); }
};

std::vector<PaintedFace> painted_faces(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  std::uint32_t count = 0;
  for (const Facet& f : facets) count = std::max(count, f.face + 1);
  std::vector<PaintedFace> faces(count);
  for (std::uint32_t i = 0; i < facets.size(); ++i) faces[facets[i].face].facets.push_back(i);
  parallel_for(faces.size(), [&](std::size_t f) {
    PaintedFace& face = faces[f];
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t i : face.facets) corners.insert(corners.end(), facets[i].v, facets[i].v + 3);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::uint32_t v : corners) {
      const double z = scene.vertices[v].z;
      face.nearest = std::min(face.nearest, z);
      face.farthest = std::max(face.farthest, z);
      face.mean += z / static_cast<double>(corners.size());
    }
  });
  return faces;
}

/// The pairs of faces that overlap on the page and differ in depth there.
std::vector<Pair> overlapping_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid) {
  std::vector<std::vector<Pair>> found(grid.top_cell_count());
  parallel_for(found.size(), [&](std::size_t i) {
    grid.for_each_leaf_of(i, [&](const Cell& cell, const CellSquare&) {
      const CellFacet* list = grid.list(cell);
      for (std::uint32_t k = 0; k < cell.count; ++k) {
        for (std::uint32_t m = k + 1; m < cell.count; ++m) {
          std::uint32_t a = list[k].facet, b = list[m].facet;
          if (facets[a].face == facets[b].face || !list[k].box.meets(list[m].box)) continue;
          if (facets[a].face > facets[b].face) std::swap(a, b);
          const FacetOrder order = order_of(facets, scene.vertices, a, b);
          if (order.tie || order.order == DepthOrder::apart || order.order == DepthOrder::level) continue;
          found[i].push_back(
              {facets[a].face, facets[b].face, order.order != DepthOrder::second, order.order != DepthOrder::first});
        }
      }
    });
    std::sort(found[i].begin(), found[i].end());
  });
  std::vector<Pair> all;
  for (const auto& of_cell : found) all.insert(all.end(), of_cell.begin(), of_cell.end());
  parallel_sort(all.begin(), all.end());
  std::size_t kept = 0;
  for (const Pair& p : all) {
    if (kept > 0 && all[kept - 1].a == p.a && all[kept - 1].b == p.b) {
      all[kept - 1].a_in_front |= p.a_in_front;
      all[kept - 1].b_in_front |= p.b_in_front;
    } else {
      all[kept++] = p;
    }
  }
  all.resize(kept);
  return all;
}

/// Sides of a plane on which corners of a face lie, beyond the tolerance of touching.
struct Sides {
  bool in_front = false, behind = false;
};

/// Each corner of the plane's facet may be off by the tolerance, weighted as its depth is.
Sides sides_of(const ProjectedScene& scene, const std::vector<Facet>& facets, const PaintedFace& of, const Facet& plane) {
  const ProjectedVertex* p[3] = {&scene.vertices[plane.v[0]], &scene.vertices[plane.v[1]], &scene.vertices[plane.v[2]]};
  const double area = orientation(p[0]->p, p[1]->p, p[2]->p);
  Sides sides;
  for (const std::uint32_t i : of.facets) {
    for (const std::uint32_t v : facets[i].v) {
      const ProjectedVertex& q = scene.vertices[v];
      double depth = 0, weights = 0;
      for (int k = 0; k < 3; ++k) {
        const double weight = orientation(p[(k + 1) % 3]->p, p[(k + 2) % 3]->p, q.p) / area;
        depth += weight * p[k]->z;
        weights += std::abs(weight);
      }
      const double tolerance = weights * plane.depth_tolerance + facets[i].depth_tolerance;
      sides.in_front |= q.z < depth - tolerance;
      sides.behind |= q.z > depth + tolerance;
    }
  }
  return sides;
}

/// Cases (a) and (b): +1 if `a` is in front of `b`, -1 if behind, 0 if these cases do not decide.
int in_front(const ProjectedScene& scene, const std::vector<Facet>& facets, const PaintedFace& a, const PaintedFace& b) {
  const auto plane_of = [&](const PaintedFace& f) -> const Facet& {
    return facets[*std::max_element(f.facets.begin(), f.facets.end(),
                                    [&](std::uint32_t i, std::uint32_t k) { return facets[i].size < facets[k].size; })];
  };
  const Sides of_b = sides_of(scene, facets, b, plane_of(a));
  if (of_b.in_front != of_b.behind) return of_b.behind ? 1 : -1;
  const Sides of_a = sides_of(scene, facets, a, plane_of(b));
  if (of_a.in_front != of_a.behind) return of_a.behind ? -1 : 1;
  return 0;
}

/// Step 2 of the lecture: the known order of pairs overrides the sort, which decides the rest. A heap holds the faces
/// that wait for no other face. If it is empty, the faces form a ring, and the first of them in the sort is taken.
void resolve(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<PaintedFace>& faces,
             const std::vector<Pair>& pairs, PaintSequence& sequence) {
  std::vector<std::int8_t> known(pairs.size(), 0);
  std::vector<std::uint8_t> by_depths(pairs.size(), 0);
  parallel_for(pairs.size(), [&](std::size_t i) {
    const PaintedFace &a = faces[pairs[i].a], &b = faces[pairs[i].b];
    by_depths[i] = a.farthest < b.nearest || b.farthest < a.nearest;
    known[i] = static_cast<std::int8_t>(by_depths[i] ? (a.farthest < b.nearest ? 1 : -1) : in_front(scene, facets, a, b));
  });
  std::vector<std::uint32_t> waits_for(faces.size(), 0);
  const auto behind = [&](std::size_t i) { return known[i] > 0 ? pairs[i].b : pairs[i].a; };
  const auto before = [&](std::size_t i) { return known[i] > 0 ? pairs[i].a : pairs[i].b; };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ++(by_depths[i] ? sequence.by_depths : known[i] != 0 ? sequence.by_planes : sequence.left);
    if (known[i] != 0) ++waits_for[before(i)];
  }
  const IndexLists later(faces.size(), [&](const auto& put) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (known[i] != 0) put(behind(i), before(i));
    }
  });
  std::vector<std::uint32_t> rank(faces.size(), 0);
  for (std::uint32_t i = 0; i < sequence.faces.size(); ++i) rank[sequence.faces[i]] = i;
  const std::vector<std::uint32_t> sorted = std::move(sequence.faces);
  sequence.faces.clear();
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free;  // by rank
  for (const std::uint32_t f : sorted) {
    if (waits_for[f] == 0) free.push(rank[f]);
  }
  std::vector<std::uint8_t> painted(faces.size(), 0);
  std::size_t oldest = 0;
  while (sequence.faces.size() < sorted.size()) {
    check_stop();
    if (free.empty()) {
      while (painted[sorted[oldest]]) ++oldest;
      ++sequence.in_rings;
      free.push(static_cast<std::uint32_t>(oldest));
    }
    const std::uint32_t f = sorted[free.top()];
    free.pop();
    if (painted[f]) continue;
    painted[f] = 1;
    sequence.faces.push_back(f);
    for (const std::uint32_t face : later[f]) {
      if (--waits_for[face] == 0 && !painted[face]) free.push(rank[face]);
    }
  }
}

}  // namespace

PaintSequence paint_sequence(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                             DepthSort sort) {
  const std::vector<PaintedFace> faces = painted_faces(scene, facets);
  PaintSequence sequence;
  sequence.level = true;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (faces[f].facets.empty()) continue;
    sequence.faces.push_back(f);
    sequence.level &= faces[f].nearest == faces[f].farthest;
  }
  const auto key = [&](std::uint32_t f) { return sort == DepthSort::mean ? faces[f].mean : faces[f].farthest; };
  std::stable_sort(sequence.faces.begin(), sequence.faces.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) > key(b); });
  // If every face has constant depth, the sort is right for every pair.
  const std::vector<Pair> pairs = sequence.level ? std::vector<Pair>{} : overlapping_pairs(scene, facets, grid);
  sequence.overlapping = pairs.size();
  if (sort == DepthSort::resolved) resolve(scene, facets, faces, pairs, sequence);
  sequence.place_of.assign(faces.size(), PaintSequence::kNever);
  for (std::uint32_t i = 0; i < sequence.faces.size(); ++i) sequence.place_of[sequence.faces[i]] = i;
  for (const Pair& p : pairs) {
    if (p.a_in_front && p.b_in_front) {
      ++sequence.penetrating;
    } else {
      sequence.wrong += p.a_in_front != (sequence.place(p.a) > sequence.place(p.b));
    }
  }
  return sequence;
}

}  // namespace ligne::painter
