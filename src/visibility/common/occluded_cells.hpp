#pragma once
/// The page cut into squares, with marks on those in which no line is visible.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "visibility/common/open_parts.hpp"

namespace ligne {

/// Squares of a whole, even number of lattice steps.
struct PageSquares {
  std::int64_t x = 0, y = 0, size = 2;  ///< corner of the first square, and side of all
  std::int64_t columns = 1, rows = 1;

  std::size_t count() const { return static_cast<std::size_t>(columns * rows); }
  std::int64_t column_of(std::int64_t at) const { return clamped(at - x, columns); }
  std::int64_t row_of(std::int64_t at) const { return clamped(at - y, rows); }
  std::size_t number(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns + column);
  }

 private:
  std::int64_t clamped(std::int64_t offset, std::int64_t n) const {
    const std::int64_t i = offset < 0 ? 0 : offset / size;
    return i < n ? i : n - 1;
  }
};

/// For a scene that is part of a model: marks the squares in which an object outside the scene hides every line.
struct OccludedCells {
  PageSquares squares;
  std::vector<std::uint8_t> blank;  ///< per square: 1 if no line is visible in it

  /// Removes the parts of a line that lie in blank squares.
  void take_from(std::vector<LinePart>& parts, const PageLine& line) const;
};

}  // namespace ligne
