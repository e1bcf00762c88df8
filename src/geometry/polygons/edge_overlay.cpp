#include "geometry/polygons/edge_overlay.hpp"

#include <algorithm>

namespace ligne {
namespace {

int sign(double v) { return (v > 0) - (v < 0); }

/// Side of the run's end at t, given the sides of the segment's ends a and b, where most runs end.
int side_of_end(const LatticeSegment& line, const LatticeSegment& s, SegmentParameter t, double at_a, double at_b) {
  if (t.num == 0) return sign(at_a);
  if (t.num == t.den) return sign(at_b);
  if (t.num > 0 && t.num < t.den && at_a * at_b > 0) return sign(at_a);
  return side(line, s, t);
}

/// Parameter of a lattice point that lies on the line.
SegmentParameter parameter_of(const LatticeSegment& line, LatticePoint p) {
  const bool along_x = std::abs(line.dx()) >= std::abs(line.dy());
  const double num = along_x ? double(p.x) - line.a.x : double(p.y) - line.a.y, den = along_x ? line.dx() : line.dy();
  return den > 0 ? SegmentParameter{num, den} : SegmentParameter{-num, -den};
}

}  // namespace

void EdgeOverlay::add(const ContourFace& face, unsigned set) {
  for (const EdgeLoop& loop : face.contours) {
    for (const ContourEdge& e : loop) add(e, set);
  }
}

/// Adds the ends of an edge on the same line: no winding need change there, but edges on the line are to be cut there
/// too.
void EdgeOverlay::add_ends(const LatticeSegment& line, const ContourEdge& edge, SegmentParameter from, SegmentParameter to) {
  for (const SegmentParameter t : {edge.from, edge.to}) {
    SegmentParameter on_line;
    if (edge.segment == line) {
      on_line = t;
    } else if (t.num == 0 || t.num == t.den) {
      on_line = parameter_of(line, t.num == 0 ? edge.segment.a : edge.segment.b);
    } else {
      continue;  // a corner of its face, where another edge of that face crosses the line
    }
    if (compare(from, on_line) < 0 && compare(on_line, to) < 0) events_.push_back({on_line, 0, 0, 0, false});
  }
}

EdgeSides EdgeOverlay::start(std::size_t i, SegmentParameter from, SegmentParameter to) {
  EdgeSides sides;
  events_.clear();
  const LatticeSegment line = edges_[i].edge.segment;
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    if (k == i) continue;
    const ContourEdge& e = edges_[k].edge;
    const double at_a = orientation(line.a, line.b, e.segment.a), at_b = orientation(line.a, line.b, e.segment.b);
    if (at_a * at_b > 0 && edges_[k].within) continue;
    int first = side_of_end(line, e.segment, e.from, at_a, at_b), last = side_of_end(line, e.segment, e.to, at_a, at_b);
    if (first == last) {
      if (first == 0) add_ends(line, edges_[k].edge, from, to);
      continue;
    }
    if (e.reversed) std::swap(first, last);
    Event event{{}, edges_[k].set, 0, 0, first != 0 && last != 0};
    // A walker on the line who crosses an edge that runs from left to right enters its inside.
    if ((first > 0) != (last > 0)) event.left = first > 0 ? 1 : -1;
    if ((first < 0) != (last < 0)) event.right = first < 0 ? -1 : 1;
    event.t = crossing(line, e.segment);
    if (compare(event.t, from) <= 0) {
      sides.left[event.set] += event.left;
      sides.right[event.set] += event.right;
    } else if (compare(event.t, to) < 0) {
      events_.push_back(event);
    }
  }
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return compare(a.t, b.t) < 0; });
  return sides;
}

}  // namespace ligne
