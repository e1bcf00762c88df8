#pragma once
/// Where on the page something is drawn.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::check {

struct PageSegment {
  Point2 a{0, 0}, b{0, 0};
};

/// Segments sorted into square cells of the page.
class StrokeGrid {
 public:
  /// Asked for no more than `reach_mm`.
  StrokeGrid(std::vector<PageSegment> segments, double reach_mm);
  /// Whether a segment passes within the reach of the point.
  bool near(Point2 p) const;

 private:
  template <class Visit>
  void visit_cells(const PageSegment& s, const Visit& visit) const;

  std::vector<PageSegment> segments_;
  double reach_;
  Point2 origin_{0, 0};
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_, members_;
};

/// Distance from a point to a segment.
double distance_mm(Point2 p, const PageSegment& s);

}  // namespace ligne::check
