#pragma once
/// The scene of the exact scan: the edges of all facets and lines, in scan order.
///
/// Notation: the scan goes down the page and, at one height, from left to right. Point p comes before point q if (p.y, p.x)
/// < (q.y, q.x). The scan line is thought of as slightly inclined, its left end lower, so that it meets the points of one
/// height in turn and horizontal edges need no special case. The *top* of an edge is its first point, the *bottom* its last.
/// `side(e, q)` is positive if q lies on the side of e that the scan line meets first (left); it is exact on the lattice.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne::watkins {

inline bool comes_before(LatticePoint a, LatticePoint b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Twice the area of (top, bottom, q): positive left of the edge, negative right of it, 0 on its line.
inline double side(LatticePoint top, LatticePoint bottom, LatticePoint q) { return orientation(top, bottom, q); }

/// A segment of the page that bounds facets, or is a candidate line, or both. Segments with equal ends are one edge.
struct SweepEdge {
  LatticePoint top{}, bottom{};
  std::uint32_t top_point = 0, bottom_point = 0;   ///< indices of its points
  std::uint32_t facets_begin = 0, facets_end = 0;  ///< range in SweepScene::edge_facets
  std::uint32_t lines_begin = 0, lines_end = 0;    ///< range in SweepScene::edge_lines
};

/// A line whose visible parts are computed.
struct SweepLine {
  ProjectedVertex from, to;
  std::uint32_t face0 = kNone, face1 = kNone;
  bool behind = false;  ///< known to be hidden, so it is not studied

  bool to_study() const { return !behind && !(from.p == to.p); }
};

/// A use of a segment: as a side of facet or face `index`, or as line `index`.
struct SegmentUse {
  std::uint32_t other;  ///< the end with the higher number
  bool line;
  std::uint32_t index;
  friend auto operator<=>(const SegmentUse&, const SegmentUse&) = default;
};

/// The uses of segments by the end with the lower number, sorted. for_each_use(use) calls use(end, end, line, index) for
/// all.
template <class ForEachUse>
ListsOf<SegmentUse> uses_by_end(std::size_t ends, const ForEachUse& for_each_use) {
  ListsOf<SegmentUse> uses(ends, [&](const auto& put) {
    for_each_use([&](std::uint32_t a, std::uint32_t b, bool line, std::uint32_t index) {
      put(std::min(a, b), SegmentUse{std::max(a, b), line, index});
    });
  });
  parallel_for(ends, [&](std::size_t end) { std::ranges::sort(uses[end]); });
  return uses;
}

/// Invariants: points ascend; edges ascend by top_point; no edge lists a facet twice.
struct SweepScene {
  std::vector<LatticePoint> points;  ///< the distinct ends of edges
  std::vector<SweepEdge> edges;
  std::vector<std::uint32_t>
      first_start;  ///< by point, plus one entry: edges [first_start[p], first_start[p + 1]) begin at p
  IndexLists ends;  ///< edges by their bottom point
  std::vector<std::uint32_t> edge_facets, edge_lines;

  std::span<const std::uint32_t> facets_of(const SweepEdge& e) const {
    return {edge_facets.data() + e.facets_begin, edge_facets.data() + e.facets_end};
  }
  std::span<const std::uint32_t> lines_of(const SweepEdge& e) const {
    return {edge_lines.data() + e.lines_begin, edge_lines.data() + e.lines_end};
  }
};

/// True if the scene is in scan order. Both functions below assert it.
bool is_in_scan_order(const SweepScene& scene);

/// Omits lines whose ends share a lattice point, and lines known to be hidden.
SweepScene make_sweep_scene(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                            std::span<const SweepLine> lines);

/// Points [first, end) of the scene, and the edges that enter the band from above.
struct SweepBand {
  std::uint32_t first = 0, end = 0;
  std::vector<std::uint32_t> active;
};

/// Bands of about equal numbers of points. Their number depends only on the scene.
std::vector<SweepBand> make_bands(const SweepScene& scene);

/// Limits the effort of a scan. If hundreds of facets overlap all over the page, each of a million events examines hundreds
/// of them. The scan of a band may examine a multiple of its points; beyond it gives up, and its work is done by grid cells.
class ScanEffort {
 public:
  explicit ScanEffort(std::size_t points) : left_(kLooksPerPoint * std::max(points, kFewPoints)) {}

  void spend(std::uint64_t looks) { left_ -= std::min(left_, looks); }
  bool spent() const { return left_ == 0; }

 private:
  // Examined elements allowed per point; smallest number of points that counts. Tuned.
  static constexpr std::uint64_t kLooksPerPoint = 8192;
  static constexpr std::size_t kFewPoints = 4096;

  std::uint64_t left_;
};

}  // namespace ligne::watkins
