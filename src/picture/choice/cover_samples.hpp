#pragma once
/// How many triangles of a set lie over the points of a regular grid.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A triangle costs its number of rows, however large it is. Of triangles with a common side each point has one.
class CoverSamples {
 public:
  struct Cover {
    double mean = 0;         ///< over the points that have one at all
    std::uint32_t most = 0;  ///< at any point
  };

  /// Points in `rows` rows over the rectangle, as many in a row as make squares, up to `rows` for each unit of its width by
  /// its height, and no more than kMostColumns.
  CoverSamples(const Rect& around, std::uint32_t rows);

  void add(const std::array<Point2, 3>& corners);
  Cover cover() const;

 private:
  static constexpr std::uint32_t kMostColumns = 4096;

  std::uint32_t columns_, rows_;
  Point2 corner_;
  double width_, height_;            ///< of a cell, whose centre is the point
  std::vector<std::int32_t> steps_;  ///< by which the count changes from one point of a row to the next
};

}  // namespace ligne
