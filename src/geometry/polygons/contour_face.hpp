#pragma once
/// Faces whose contours refer to the lattice segments that they came from.
///
/// A corner made by a clip lies on no lattice, so it is not stored as a point. An edge of a contour is a run on a
/// *source segment*, from one exact parameter to another; the ends of the segment are lattice points. Clipping shortens
/// runs but never changes a segment. So every predicate is exact on the segments as given, after any number of clips, and
/// each piece of a border knows its source. A corner as a point is rounded to the fine lattice (FinePoint).

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exact_segment.hpp"

namespace ligne {

/// A run on a source segment, from the parameter `from` to `to`, from < to; `reversed` when the contour runs against the
/// segment. The inside of the face lies on the left (orientation() positive) of the direction in which the contour runs.
struct ContourEdge {
  LatticeSegment segment;
  SegmentParameter from = kSegmentBegin, to = kSegmentEnd;
  std::uint32_t source = 0;  ///< the caller's number of the segment
  bool reversed = false;

  FinePoint begin() const { return fine_point(segment, reversed ? to : from); }
  FinePoint end() const { return fine_point(segment, reversed ? from : to); }
  /// Direction in which the contour runs. Exact.
  double dx() const { return reversed ? -segment.dx() : segment.dx(); }
  double dy() const { return reversed ? -segment.dy() : segment.dy(); }
};

/// A closed contour: each edge begins where the one before it ends.
using EdgeLoop = std::vector<ContourEdge>;

/// A face with holes: the first contour is the outer one and turns positively, the others are holes and turn negatively.
struct ContourFace {
  std::vector<EdgeLoop> contours;
  bool is_convex = false;  ///< known to be one convex contour; see geometry/polygons/convex_clip.hpp
};

/// Makes a face from closed contours of lattice points, the first one outer, in either winding. The edges get the
/// sources `first_source`, `first_source` + 1 and so on, one per corner. Repeated corners are skipped. Contours may
/// touch themselves and each other, but must not cross.
ContourFace make_contour_face(std::span<const std::vector<LatticePoint>> contours, std::uint32_t first_source = 0);

/// Links edges, given in any order, to faces. The edges must form closed contours with the inside on their left. One of
/// several coincident edges is kept; coincident edges that run in opposite directions are all dropped.
///
/// Invariants: contours of one face do not cross; a corner appears once in a contour; faces that share only corners are
/// separate faces. Consecutive runs on one source are merged, except where other contours touch. Contours without area
/// are left out.
///
/// With `closed`, contours stay closed exactly, not only on the fine lattice: a contour keeps runs whose begin() and end()
/// are equal there, which are otherwise left out. Use it for faces that will be clipped again, since lines along their
/// edges could pass through the gap. The first of several coincident edges is then kept, otherwise the one with the lowest
/// source.
std::vector<ContourFace> link_edges(std::vector<ContourEdge> edges, bool closed = false);

/// Twice the signed area in square steps, computed exactly from the corners on the fine lattice and rounded once.
double twice_area(const EdgeLoop& loop);
double twice_area(const ContourFace& face);
double twice_area(std::span<const ContourFace> faces);

/// +1 inside, 0 on a contour, -1 outside, with the corners rounded to the fine lattice.
int position_in_face(const ContourFace& face, FinePoint p);

}  // namespace ligne
