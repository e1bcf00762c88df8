#pragma once
/// Windows with borders in any direction, for divisions along sides of faces.
///
/// A convex window is an intersection of half planes. Each lies to the left of a line through two points of the lattice;
/// these points alone decide to which window a part of a line belongs. Corners of a window are computed points: they lie
/// within 2^-20 lattice steps of their borders. Faces are therefore compared with the window and a margin of at least one
/// step, which makes the lists of a window complete.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "visibility/warnock/window.hpp"

namespace ligne::warnock {

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
