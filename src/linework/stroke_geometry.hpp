#pragma once
/// Kinds, lengths, pieces and intervals of strokes on the page, and the faces in front of hidden ones.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "linework/stroke.hpp"

namespace ligne {

/// True for strokes that are seen directly, not only through transparent faces.
inline bool is_seen(const Stroke& s) { return s.visible && s.level == 0; }

/// True for edges of the scene and intersections; false for lines of surfaces and axes, which no rule changes.
inline bool is_edge(const Stroke& s) { return static_cast<std::size_t>(s.line_class) < kEdgeClassCount; }

/// True for lines that rules join and extend: edges that are not mere mesh edges.
inline bool is_feature(const Stroke& s) { return is_edge(s) && s.line_class != LineClass::mesh; }

/// Length of a stroke on the page, lattice steps.
inline double page_length(const Stroke& s) { return length(s.from, s.to); }

/// An end of a stroke.
struct StrokeTip {
  LatticePoint p;
  float z, w;  ///< depth and weight
};

/// Even numbers of ends stand for `from`, odd ones for `to`.
inline StrokeTip tip(const Stroke& s, std::uint32_t end) {
  return end % 2 == 0 ? StrokeTip{s.from, s.z_from, s.w_from} : StrokeTip{s.to, s.z_to, s.w_to};
}

/// A stroke between two tips that is like another one.
inline Stroke stroke_between(Stroke like, const StrokeTip& from, const StrokeTip& to) {
  like.from = from.p, like.z_from = from.z, like.w_from = from.w;
  like.to = to.p, like.z_to = to.z, like.w_to = to.w;
  return like;
}

/// The vector between two points, exact.
inline Point2 offset(LatticePoint from, LatticePoint to) { return {double(to.x) - from.x, double(to.y) - from.y}; }

/// The lattice point nearest to a point, steps.
inline LatticePoint nearest_step(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}
inline LatticePoint moved(LatticePoint p, Point2 by) { return nearest_step(p.x + by.x, p.y + by.y); }

/// The point at a fraction of a stroke's length, rounded to the lattice.
inline LatticePoint point_at(const Stroke& s, double fraction) { return moved(s.from, fraction * offset(s.from, s.to)); }

/// The point of a segment that is nearest to a given point.
struct FootPoint {
  double fraction = 0;  ///< of the segment's length, from 0 to 1
  double distance = 0;  ///< lattice steps
};
inline FootPoint foot_on(const Stroke& s, LatticePoint p) {
  const Point2 line = offset(s.from, s.to), to_p = offset(s.from, p);
  const double square = glm::dot(line, line), t = square > 0 ? std::clamp(glm::dot(to_p, line) / square, 0.0, 1.0) : 0;
  return {t, glm::length(to_p - t * line)};
}

/// A point at which a stroke is cut.
struct StrokeCut {
  double fraction;  ///< of the stroke's length on the page; beyond 0 to 1 the stroke is extended
  LatticePoint p;   ///< the point, rounded to the lattice
};

/// The piece of a stroke between two cuts, or its extension to them. Its parameters, depths and weights are interpolated.
inline Stroke stroke_piece(const Stroke& s, const StrokeCut& from, const StrokeCut& to) {
  const auto put_end = [&](const StrokeCut& cut, LatticePoint& p, double& t, float& z, float& w) {
    p = cut.p;
    t = source_parameter(s, cut.fraction);
    z = static_cast<float>((1 - cut.fraction) * s.z_from + cut.fraction * s.z_to);
    const double u = (t - s.t_from) / (s.t_to - s.t_from);
    w = static_cast<float>((1 - u) * s.w_from + u * s.w_to);
  };
  Stroke part = s;
  if (from.fraction != 0) put_end(from, part.from, part.t_from, part.z_from, part.w_from);
  if (to.fraction != 1) put_end(to, part.to, part.t_to, part.z_to, part.w_to);
  return part;
}

/// Moves an end of a stroke along it, at most to the end of its source edge.
inline void move_end(Stroke& s, bool first, const StrokeCut& to) {
  s = first ? stroke_piece(s, to, {1, s.to}) : stroke_piece(s, {0, s.from}, to);
  s.t_from = std::max(s.t_from, 0.0);
  s.t_to = std::min(s.t_to, 1.0);
}

/// An interval of a stroke, as fractions of its length from 0 to 1. Empty if from > to.
struct StrokePart {
  double from = 2, to = -1;

  bool empty() const { return from > to; }
  /// Extends this interval so that it contains the intersection of [a, b] and [0, 1].
  void add(double a, double b) {
    a = std::max(a, 0.0);
    b = std::min(b, 1.0);
    if (a > b) return;
    from = std::min(from, a);
    to = std::max(to, b);
  }
  /// Keeps the fractions t at which `start` + t `slope` lies between the bounds.
  void keep(double start, double slope, double low, double high) {
    if (slope == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double a = (low - start) / slope, b = (high - start) / slope;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

/// Sorts intervals and merges those that overlap or touch.
void unite(std::vector<StrokePart>& parts);

/// The part of a stroke of non-zero length within `reach` lattice steps of another stroke. The set of points within a
/// distance of a segment is convex, so the part is one interval.
StrokePart part_near(const Stroke& stroke, const Stroke& other, double reach);

/// Side of the cells of a grid through which all strokes are walked, in lattice steps. It is `wanted`, unless the
/// strokes would pass more than 64 cells on average and a quarter of a million in all. Then it is larger by that ratio,
/// so that a very fine pen on a large page needs no more memory than the strokes.
double walked_cell(const std::vector<Stroke>& strokes, double wanted);

/// Returns the part of StrokeModel::hidden_parts at the parameter `t` of a source, or null.
const HiddenPart* hidden_part_at(const StrokeModel& model, std::uint32_t source, double t);

/// Returns the part at the middle of a stroke. Null if the stroke is visible or no faces were counted there.
const HiddenPart* hidden_part_of(const StrokeModel& model, const Stroke& stroke);

/// Removes the hidden strokes that more than `most` faces hide. Strokes without a number stay.
void leave_out_often_hidden(StrokeModel& model, unsigned most);

}  // namespace ligne
