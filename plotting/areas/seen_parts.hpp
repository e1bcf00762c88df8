#pragma once
/// Cuts lines down to their visible parts. Private to plotting.

#include <span>
#include <vector>

#include "areas/steps.hpp"
#include "drawing/drawing.hpp"

namespace ligne::svg {

/// A part of a segment, from the end of the part before it, as a fraction of the segment.
struct SeenPart {
  double end = 1;
  bool seen = true;
};

/// Shortest part of a segment, in lattice steps: shorter ones come from rounding where edges meet.
inline constexpr double kLeastPartSteps = 4;

/// Cuts one line after the other.
class LineCutter {
 public:
  /// Adds the visible parts of the line to `out`. `find_parts(segment, parts)` appends the parts of a segment, the last
  /// one ending at 1. Consecutive points with one lattice point are merged. A line with a single lattice point is
  /// tested as a segment of one step, and is visible as a whole or not at all.
  template <class FindParts>
  void cut(std::span<const Point2> line, Polylines& out, FindParts find_parts) {
    take_points(line);
    if (points_.size() < 2) {
      if (line.size() < 2) return;
      parts_.clear();
      const StepPoint at = steps_[0];
      find_parts(StepSegment{at, {at.x + 1, at.y}}, parts_);
      if (parts_[0].seen) out.add(line);
      return;
    }
    for (std::size_t k = 1; k < points_.size(); ++k) {
      parts_.clear();
      find_parts(StepSegment{steps_[k - 1], steps_[k]}, parts_);
      add_parts(k, out);
    }
    end(out);
  }

 private:
  void take_points(std::span<const Point2> line);
  void drop_short_parts(double length_steps);
  void add_parts(std::size_t k, Polylines& out);
  void end(Polylines& out);

  std::vector<Point2> points_, run_;
  std::vector<StepPoint> steps_;
  std::vector<SeenPart> parts_;
};

}  // namespace ligne::svg
