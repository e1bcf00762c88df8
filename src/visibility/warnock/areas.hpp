#pragma once
/// The visible areas of a window: it is cut into trapezoids along the sides of its faces, and of each the face in front is
/// known.
///
/// A trapezoid lies between two lines of constant u; it is bounded below and above (towards -v and +v) by a side of a face,
/// a line of intersection, or a border of the window. All that meet at a line of constant u compute the places of their
/// corners from the same numbers, to the last bit.

#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/warnock/solution.hpp"

namespace ligne::warnock {

/// A straight line on the page, ends in ascending order of u: what bounds trapezoids. Horizontal lines of the window have
/// the same v at both ends.
struct Boundary {
  FramePoint p, q;

  /// v at u, the same for all who ask.
  double v(double u) const;
  friend bool operator==(const Boundary& a, const Boundary& b) {
    return a.p.u == b.p.u && a.p.v == b.p.v && a.q.u == b.q.u && a.q.v == b.q.v;
  }
};

/// A trapezoid, u0 < u1, low.v <= high.v over it (but for rounding).
struct AreaPiece {
  double u0 = 0, u1 = 0;
  Boundary low, high;
  std::uint32_t face = kNone;  ///< of the scene, kNone where nothing is seen
};

/// Working memory for many windows.
class AreaSearch {
 public:
  AreaSearch(const FaceTable& table, const std::vector<PageLine>& lines) : table_(table), lines_(lines) {}

  /// Appends the trapezoids of the window on which a face is seen. `intersections`: pieces of lines in which faces
  /// penetrate.
  void find(const Lists& lists, const Window& window, std::span<const Piece> intersections, std::vector<AreaPiece>& out);

  /// The whole window, with the face that is in front at its centre.
  void take_front(const Lists& lists, const Window& window, std::vector<AreaPiece>& out) const;

 private:
  struct Segment {
    FramePoint p, q;  ///< as of a Boundary
    double u0, u1;    ///< its part in the window
  };
  void collect(const Lists& lists, const Window& window, std::span<const Piece> intersections);
  void add_segment(FramePoint p, FramePoint q, const Window& window);
  void find_crossings(const Window& window);
  std::uint32_t front_at(const Lists& lists, double u, double v) const;

  const FaceTable& table_;
  const std::vector<PageLine>& lines_;
  std::vector<Segment> segments_;
  std::vector<double> events_;
};

}  // namespace ligne::warnock
