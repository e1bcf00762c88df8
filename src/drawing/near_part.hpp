#pragma once
/// The part of a stroke that lies near another one.

#include <algorithm>

#include "drawing/stroke.hpp"

namespace ligne {

/// A part of a stroke, as fractions of it; none where from > to.
struct StrokePart {
  double from = 2, to = -1;

  bool empty() const { return from > to; }
  /// The hull of this part and [a, b], of what lies on the stroke.
  void add(double a, double b) {
    a = std::max(a, 0.0);
    b = std::min(b, 1.0);
    if (a > b) return;
    from = std::min(from, a);
    to = std::max(to, b);
  }
};

/// The part of a stroke, which has a length, within `reach` lattice steps of another one. What lies within a distance of a
/// segment is convex, so it is one part.
StrokePart part_near(const Stroke& stroke, const Stroke& other, double reach);

}  // namespace ligne
