#pragma once
/// The part of a stroke that lies near another stroke.

#include <algorithm>

#include "linework/stroke.hpp"

namespace ligne {

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
};

/// The part of a stroke of non-zero length within `reach` lattice steps of another stroke. The set of points within a
/// distance of a segment is convex, so the part is one interval.
StrokePart part_near(const Stroke& stroke, const Stroke& other, double reach);

}  // namespace ligne
