#pragma once
/// Windows with borders in any direction, for divisions along sides of faces.
///
/// A convex window is an intersection of half planes. Each lies to the left of a line through two points of the lattice;
/// these points alone decide to which window a part of a line belongs. Corners of a window are computed points: they lie
/// within 2^-20 lattice steps of their borders. Faces are therefore compared with the window and a margin of at least one
/// step, which makes the lists of a window complete.

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::warnock {

/// Windows, and exact tests of segments and points against them.
///
/// Notation: a frame (a, b), an integer vector on the page lattice, gives the axes of all windows of a study: u = a x + b y,
/// v = a y - b x. (1, 0) is the page itself. With |a|, |b| <= 2^25 both are integers below 2^52, exact in doubles. Signs of
/// determinants are decided in doubles where the error bound allows, and in 128-bit integers otherwise.
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

/// The half plane to the left of p -> q, moved to the left by `shift` frame units.
class Border {
 public:
  /// p and q differ.
  Border(FramePoint p, FramePoint q);

  /// How far the point lies inside, in frame units; negative outside.
  double distance(FramePoint r) const { return nu_ * (r.u - p_.u) + nv_ * (r.v - p_.v) - shift_; }
  /// Exact sign of distance() while the border is not moved.
  int side(FramePoint r) const { return turn(p_, q_, r); }
  friend bool operator==(const Border&, const Border&) = default;
  Border opposite() const { return {q_, p_}; }
  Border moved(double units) const;

 private:
  FramePoint p_, q_;
  double nu_, nv_, shift_ = 0;  ///< unit normal that points inside
};

class ConvexWindow {
 public:
  explicit ConvexWindow(const Window& rectangle);

  /// Its part inside the border.
  ConvexWindow part(const Border& border) const;
  /// All borders moved inwards. Empty when it would not hold its own middle.
  ConvexWindow shrunk(double units) const;

  bool empty() const { return edges_.size() < 3; }
  /// Box of whole numbers round the corners.
  const Window& box() const { return box_; }
  /// Mean of the corners, rounded to whole numbers.
  FramePoint middle() const { return middle_; }
  /// Corner `i` of size().
  FramePoint corner(std::size_t i) const { return edges_[i].from; }
  std::size_t size() const { return edges_.size(); }
  /// Ends of the edge that lies along a border of the window, or nothing.
  std::optional<std::pair<FramePoint, FramePoint>> edge_along(const Border& border) const;
  const Border& border(std::size_t i) const { return edges_[i].border; }

  /// Whether the segment meets the window with a margin round it. Never false for a segment that comes nearer to the window
  /// than the margin less a lattice step.
  bool meets(FramePoint p, FramePoint q, double margin) const;
  bool holds(FramePoint p) const;

 private:
  /// From one corner to the next, in the direction of the border.
  struct Edge {
    Border border;
    FramePoint from;
  };
  void cut(const Border& border);
  void measure();

  std::vector<Edge> edges_;
  Window box_{0, -1, 0, -1};
  FramePoint middle_;
};

/// A window as the modules look at it: a rectangle, or a polygon in its box. Refers to the polygon.
struct WindowShape {
  WindowShape(const Window& rectangle) : box(rectangle) {}
  WindowShape(const ConvexWindow& window) : box(window.box()), polygon(&window) {}

  Window box;
  const ConvexWindow* polygon = nullptr;

  bool empty() const { return polygon ? polygon->empty() : box.empty(); }
  bool meets(FramePoint p, FramePoint q) const { return polygon ? polygon->meets(p, q, 0) : warnock::meets(p, q, box); }
  bool holds(FramePoint p) const { return polygon ? polygon->holds(p) : box.holds(p); }
};

}  // namespace ligne::warnock
