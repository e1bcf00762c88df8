#pragma once
/// Finds the lines of the page that run beside an edge, and the stretches of the edge beside which none runs.

#include <array>
#include <optional>
#include <vector>

#include "contours/contour_junctions.hpp"

namespace ligne {

/// Segments of the page. Lengths are in mm.
class LinesBeside {
 public:
  explicit LinesBeside(const Lattice& lattice) : finder_(lattice, kCellMm) {}

  void add(Point2 from, Point2 to) { finder_.add({from, to, 0, 0}); }

  /// Whether a segment passes within the reach of the point.
  bool any_within(Point2 p, double reach) const;
  /// The point nearest to p, within the reach, at which the line through p with the direction crosses a segment that makes
  /// more than 45 degrees with it.
  std::optional<Point2> crossing(Point2 p, Point2 direction, double reach) const;
  /// The end of a segment that is nearest to the point, within the reach.
  std::optional<Point2> nearest_end(Point2 p, double reach) const;
  /// The stretches of from-to, ascending, as fractions of it, beside which no segment runs: none within the reach that
  /// makes at most 45 degrees with it. Segments are prolonged by `slack_mm` at both ends.
  std::vector<std::array<double, 2>> uncovered(Point2 from, Point2 to, double reach, double slack_mm) const;

 private:
  static constexpr double kCellMm = 1;

  SegmentFinder finder_;
};

}  // namespace ligne
