#pragma once
/// Positions of the rows and columns of a grid.

#include <cstddef>
#include <vector>

namespace ligne {

/// The ends of so many equal intervals.
inline std::vector<double> evenly(double from, double to, std::size_t intervals) {
  std::vector<double> positions;
  for (std::size_t i = 0; i <= intervals; ++i)
    positions.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(intervals));
  return positions;
}

}  // namespace ligne
