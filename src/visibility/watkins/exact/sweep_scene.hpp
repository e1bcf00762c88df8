#pragma once
/// The scene of the exact scan: the edges of all facets and all lines, in the order in which the scan meets them.
///
/// Notation: the scan goes down the page and, at one height, from left to right. Point p comes before point q when
/// (p.y, p.x) < (q.y, q.x); the scan line is thought to lean a little, its left end lower, so that it meets the points of
/// one height one after the other and horizontal edges need no rule of their own. The *top* of an edge is its first point,
/// the *bottom* its last. `side(e, q)` is positive where q lies on the side of e that the scan line meets first (left),
/// exact on the lattice.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne::watkins {

inline bool comes_before(LatticePoint a, LatticePoint b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Twice the area of (top, bottom, q): positive left of the edge, negative right of it, 0 on its line.
inline double side(LatticePoint top, LatticePoint bottom, LatticePoint q) { return orientation(top, bottom, q); }

/// A piece of page between two points that bounds facets, or is a candidate line, or both. Pieces with the same two ends are
/// one edge.
struct SweepEdge {
  LatticePoint top, bottom;
  std::uint32_t top_point = 0, bottom_point = 0;   ///< index among the points, ascending
  std::uint32_t facets_begin = 0, facets_end = 0;  ///< in SweepScene::edge_facets
  std::uint32_t lines_begin = 0, lines_end = 0;    ///< in SweepScene::edge_lines
};

/// A line whose visible parts are wanted.
struct SweepLine {
  ProjectedVertex from, to;
  std::uint32_t face0 = kNone, face1 = kNone;
  bool behind = false;  ///< known to be hidden all along: there is nothing to study

  bool to_study() const { return !behind && !(from.p == to.p); }
};

/// Invariants: points ascend; edges ascend by top_point; an edge has a facet twice never (both its sides would lie on it).
struct SweepScene {
  std::vector<LatticePoint> points;  ///< every end of an edge, once
  std::vector<SweepEdge> edges;
  std::vector<std::uint32_t>
      first_start;                       ///< by point, and one more: edges [first_start[p], first_start[p + 1]) begin there
  std::vector<std::uint32_t> first_end;  ///< the same for `ends`
  std::vector<std::uint32_t> ends;       ///< edges by the point where they end
  std::vector<std::uint32_t> edge_facets, edge_lines;

  std::span<const std::uint32_t> facets_of(const SweepEdge& e) const {
    return {edge_facets.data() + e.facets_begin, edge_facets.data() + e.facets_end};
  }
  std::span<const std::uint32_t> lines_of(const SweepEdge& e) const {
    return {edge_lines.data() + e.lines_begin, edge_lines.data() + e.lines_end};
  }
};

/// Whether the scene is in the order that the scan takes it in. Both makers below assert it.
bool is_in_scan_order(const SweepScene& scene);

/// Lines whose two ends fall on one lattice point are left out, and those that are known to be hidden.
SweepScene make_sweep_scene(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                            std::span<const SweepLine> lines);

/// Points [first, end) of the scene, and the edges that run into them from above, by number.
struct SweepBand {
  std::uint32_t first = 0, end = 0;
  std::vector<std::uint32_t> active;
};

/// Bands of about equal numbers of points. Their number depends on the scene alone.
std::vector<SweepBand> make_bands(const SweepScene& scene);

}  // namespace ligne::watkins
