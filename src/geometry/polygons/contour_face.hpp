#pragma once
/// Faces whose contours are led back to the lattice segments that they came from.
///
/// A corner made by a clip lies on no lattice, so it is not stored as a point: an edge of a contour is a run on a *source
/// segment*, whose ends are lattice points, from one exact parameter to another. A clip shortens runs and changes no
/// segment. So every predicate works on the segments as they were given, exactly, however many clips came before; and each
/// piece of a border knows where it comes from.

#include <cstdint>
#include <span>
#include <utility>
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
};

/// A face from closed contours of lattice points, the first outer, in either winding. Edges get the sources `first_source`,
/// and so on, one by corner. Repeated corners are skipped. Contours may touch themselves and each other; they are not to
/// cross.
ContourFace make_contour_face(std::span<const std::vector<LatticePoint>> contours, std::uint32_t first_source = 0);

/// Faces bounded by the edges, given in any order: with the inside on their left they form closed contours. Of edges that
/// lie on each other one is kept, and two that run against each other vanish.
///
/// Invariants: contours of one face do not cross; a corner appears once in a contour; faces that have only corners in common
/// are faces of their own. Runs on one source that follow each other are one edge, but where other contours touch it.
/// Contours without area are left out.
///
/// With `closed` contours stay closed exactly, not only on the fine lattice: runs shorter than that can resolve, which are
/// otherwise left out, are kept in a contour that passes there, begin() and end() the same. For faces that will be clipped
/// again: lines along their edges may pass through the gap. And of edges that lie on each other the first one is kept,
/// otherwise that of the lowest source.
std::vector<ContourFace> link_edges(std::vector<ContourEdge> edges, bool closed = false);

/// Twice the signed area in square steps, computed exactly from the corners on the fine lattice and rounded once.
double twice_area(const EdgeLoop& loop);
double twice_area(const ContourFace& face);
double twice_area(std::span<const ContourFace> faces);

/// +1 inside, 0 on a contour, -1 outside, for the corners as they are on the fine lattice.
int position_in_face(const ContourFace& face, FinePoint p);

}  // namespace ligne
