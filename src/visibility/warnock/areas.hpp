#pragma once
/// The visible areas of a window: trapezoids between the sides of its faces, each with the face in front.
///
/// A trapezoid lies between two lines of constant u. A side of a face, a line of intersection, or a border of the window
/// bounds it below and above (towards -v and +v). All trapezoids that meet at a line of constant u compute their corners
/// there from the same numbers, so the corners are bitwise equal.

#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/warnock/solution.hpp"

namespace ligne::warnock {

/// A straight line on the page that bounds trapezoids. Its ends are sorted by u. Horizontal borders of the window have equal
/// v at both ends.
struct Boundary {
  FramePoint p, q;

  /// v at u; bitwise equal for equal arguments.
  double v(double u) const;
  friend bool operator==(const Boundary& a, const Boundary& b) {
    return a.p.u == b.p.u && a.p.v == b.p.v && a.q.u == b.q.u && a.q.v == b.q.v;
  }
};

/// A trapezoid with u0 < u1; low.v <= high.v over it up to rounding.
struct AreaPiece {
  double u0 = 0, u1 = 0;
  Boundary low, high;
  std::uint32_t face = kNone;  ///< face of the scene, kNone where nothing is visible
};

/// Finds areas; keeps scratch memory for many windows.
class AreaSearch {
 public:
  AreaSearch(const FaceTable& table, const std::vector<PageLine>& lines) : table_(table), lines_(lines) {}

  /// Appends the trapezoids of the window with a visible face. `intersections`: pieces of lines along which faces penetrate.
  void find(const Lists& lists, const Window& window, std::span<const Piece> intersections, std::vector<AreaPiece>& out);

  /// Appends the whole window, with the face in front at its centre.
  void take_front(const Lists& lists, const Window& window, std::vector<AreaPiece>& out) const;

 private:
  struct Segment {
    FramePoint p, q;  ///< ends sorted by u, as in Boundary
    double u0, u1;    ///< the part within the window
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
