#pragma once
/// Finds the lines of the page that run beside an edge, and the stretches of the edge beside which none runs.

#include <array>
#include <optional>
#include <vector>

#include "contours/contour_junctions.inl.hpp"

namespace ligne {

/// Segments of the page, searched near edges that are announced beforehand. Lengths are in mm.
class LinesBeside {
 public:
  LinesBeside() : finder_(kCellMm) {}

  /// Announces queries within the reach of from-to. To be called before the first add().
  void expect(Point2 from, Point2 to, double reach) {
    for_steps(from, to, reach, [&](Point2 low, Point2 high) { finder_.expect(low, high); });
  }
  void add(Point2 from, Point2 to) { finder_.add({from, to, 0, 0}); }

  /// Whether a segment passes within the reach of the point.
  bool any_within(Point2 p, double reach) const;
  /// The end of a segment that is nearest to the point, within the reach.
  std::optional<Point2> nearest_end(Point2 p, double reach) const;
  /// The stretches of from-to, ascending, as fractions of it, beside which no segment runs: none within the reach that
  /// makes at most 45 degrees with it. Segments are prolonged by `slack_mm` at both ends.
  std::vector<std::array<double, 2>> uncovered(Point2 from, Point2 to, double reach, double slack_mm) const;

 private:
  static constexpr double kCellMm = 1;

  /// Calls visit(low, high) for boxes that contain all places within the reach of from-to.
  template <class Visit>
  static void for_steps(Point2 from, Point2 to, double reach, Visit visit) {
    const int steps = 1 + static_cast<int>(glm::length(to - from) / std::max(kCellMm, reach));
    for (int i = 0; i < steps; ++i) {
      const Point2 a = from + double(i) / steps * (to - from), b = from + double(i + 1) / steps * (to - from);
      visit(glm::min(a, b) - Point2(reach), glm::max(a, b) + Point2(reach));
    }
  }

  SegmentFinder finder_;
};

}  // namespace ligne
