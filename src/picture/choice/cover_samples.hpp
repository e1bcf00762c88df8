#pragma once
/// Counts the triangles of a set over the points of a regular grid.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A triangle costs one step for each of its rows, whatever its size. A point on the common side of two triangles
/// counts for one of them.
class CoverSamples {
 public:
  struct Cover {
    double mean = 0;         ///< over the points with at least one triangle
    std::uint32_t most = 0;  ///< at any point
    double share = 0;        ///< share of the points that have a triangle
  };

  /// Sample points in `rows` rows over the rectangle. Their columns make the cells square, up to kMostColumns.
  CoverSamples(const Rect& around, std::uint32_t rows);

  void add(const std::array<Point2, 3>& corners);
  Cover cover() const;

 private:
  static constexpr std::uint32_t kMostColumns = 4096;

  std::uint32_t columns_, rows_;
  Point2 corner_;
  double width_, height_;            ///< size of a cell, whose centre is the sample point
  std::vector<std::int32_t> steps_;  ///< change of the count from one point of a row to the next
};

}  // namespace ligne
