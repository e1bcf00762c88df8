#pragma once
/// Joins the visible pieces of a curve to polylines, one for each stretch that is visible without a break.

#include <cmath>
#include <vector>

#include "drawing/drawing.hpp"
#include "view/clip.hpp"
#include "view/tolerances.hpp"

namespace ligne::horizon {

class CurveTracker {
 public:
  /// Adds the visible part from t0 to t1 of the segment a, b in space; it goes to `lines`. Parts must come in order
  /// along the curve.
  void add(const HomogeneousPoint& a, const HomogeneousPoint& b, double t0, double t1, Polylines& lines) {
    if (!(continues_ && t0 == 0 && lines_ == &lines)) {
      end();
      lines_ = &lines;
      points_.push_back(at(a, b, t0));
    }
    points_.push_back(at(a, b, t1));
    continues_ = false;
    reached_end_ = t1 == 1;
  }

  /// Ends a segment: the next parts belong to the following segment.
  void next_segment() {
    continues_ = reached_end_;
    reached_end_ = false;
  }

  /// Ends a segment of which nothing is visible.
  void interrupt() { continues_ = reached_end_ = false; }

  /// Ends the stretch, and puts it into its polylines.
  void end() {
    double length = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      length += std::hypot(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y);
    if (length > kLeastPartMm) {
      lines_->points.insert(lines_->points.end(), points_.begin(), points_.end());
      lines_->begin.push_back(static_cast<std::uint32_t>(lines_->points.size()));
    }
    points_.clear();
  }

  static Point2 at(const HomogeneousPoint& a, const HomogeneousPoint& b, double t) {
    const HomogeneousPoint p = t == 0 ? a : t == 1 ? b : interpolate(a, b, t);
    return {p.x / p.w, p.y / p.w};
  }

 private:
  Polylines* lines_ = nullptr;
  std::vector<Point2> points_;
  bool continues_ = false, reached_end_ = false;
};

}  // namespace ligne::horizon
