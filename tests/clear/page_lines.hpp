#pragma once
/// Segments of the page in a grid, asked for the nearest one.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::test {

class PageLines {
 public:
  /// `sheet` holds all segments; `cell_mm` is about the distance that is asked for.
  PageLines(const Rect& sheet, double cell_mm);

  void add(Point2 from, Point2 to);
  /// The distance of the nearest segment, mm; `limit_mm` if none is as near as that.
  double distance(Point2 p, double limit_mm) const;

 private:
  struct Segment {
    Point2 from, to;
  };
  template <class Visit>
  void each_cell(Point2 low, Point2 high, const Visit& visit) const;

  Rect sheet_;
  double cell_mm_;
  int columns_, rows_;
  std::vector<Segment> segments_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace ligne::test
