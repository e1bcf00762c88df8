#pragma once
/// Windows, and exact tests of segments and points against them.
///
/// Notation: a frame (a, b), an integer vector on the page lattice, gives the axes of all windows of a study: u = a x + b y,
/// v = a y - b x. (1, 0) is the page itself. With |a|, |b| <= 2^25 both are integers below 2^52, exact in doubles. Signs of
/// determinants are decided in doubles where the error bound allows, and in 128-bit integers otherwise.

#include <cmath>

#include "geometry/lattice.hpp"

namespace ligne::warnock {

struct FramePoint {
  double u = 0, v = 0;  ///< integers
  friend bool operator==(FramePoint, FramePoint) = default;
};

struct WindowFrame {
  double a = 1, b = 0;

  FramePoint operator()(LatticePoint p) const { return {a * p.x + b * p.y, a * p.y - b * p.x}; }
  double u(LatticePoint p) const { return a * p.x + b * p.y; }
  double v(LatticePoint p) const { return a * p.y - b * p.x; }
  /// Frame units per lattice step.
  double unit() const { return std::sqrt(a * a + b * b); }
  /// Page point in lattice steps.
  Point2 to_page(double u, double v) const {
    const double n = a * a + b * b;
    return {(a * u - b * v) / n, (b * u + a * v) / n};
  }
};

/// A closed rectangle with integer corners.
struct Window {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;

  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
  double longer_side() const { return width() > height() ? width() : height(); }
  bool empty() const { return !(u0 <= u1 && v0 <= v1); }
  /// Enlarged by an integer number of units on all sides; reduced if negative.
  Window grown(double units) const { return {u0 - units, u1 + units, v0 - units, v1 + units}; }
  bool meets(const Window& o) const { return u0 <= o.u1 && o.u0 <= u1 && v0 <= o.v1 && o.v0 <= v1; }
  bool holds(FramePoint p) const { return u0 <= p.u && p.u <= u1 && v0 <= p.v && p.v <= v1; }
  Window common(const Window& o) const {
    return {u0 > o.u0 ? u0 : o.u0, u1 < o.u1 ? u1 : o.u1, v0 > o.v0 ? v0 : o.v0, v1 < o.v1 ? v1 : o.v1};
  }
};

/// Sign of (q - p) x (r - p): positive if p -> q -> r turns from +u towards +v. Exact. Identities: turn(p,q,r) ==
/// turn(q,r,p) == -turn(q,p,r).
int turn(FramePoint p, FramePoint q, FramePoint r);

/// True if the closed segment has a point in the closed window. Exact. meets(p,q,w) == meets(q,p,w).
bool meets(FramePoint p, FramePoint q, const Window& window);

/// Contribution of the directed side p -> q to the winding number of r: +1 if it crosses the ray from r towards +u upwards
/// (towards +v), -1 downwards, else 0. The sum over a contour that does not pass r is the winding number. Exact.
int winding(FramePoint p, FramePoint q, FramePoint r);

}  // namespace ligne::warnock
