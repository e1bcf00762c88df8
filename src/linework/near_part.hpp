#pragma once
/// The part of a stroke that lies near another stroke.

#include <algorithm>
#include <vector>

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

}  // namespace ligne
