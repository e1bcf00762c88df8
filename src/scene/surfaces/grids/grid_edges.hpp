#pragma once
/// The edges of a formula's grid of samples on which its surface breaks off.

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "scene/surfaces/height_breaks.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// An edge runs from a sample to the next one in its row, or in its column.
struct GridEdge {
  std::size_t sample = 0;  ///< number of its beginning, row by row
  bool along_column = false;

  std::size_t key() const { return 2 * sample + along_column; }
};

struct BrokenEdge {
  GridEdge edge;
  std::vector<LinePiece> pieces;
};

struct BrokenEdges {
  std::vector<BrokenEdge> edges;  ///< ascending by beginning
  bool has_pole = false;
};

/// Height that is nothing to see: this part of the range of heights.
inline constexpr double kLeastHeightPart = 0x1p-10;

/// The range of the samples that count in a window.
struct SampleSpan {
  double low = 0, high = 0;
  Point2 lowest{}, highest{};    ///< where
  bool any = false, all = true;  ///< samples that count

  double range() const { return high - low; }
};
SampleSpan span_of_samples(const HeightSource& heights, const HeightWindow& window);

/// All edges with a piece less or more than their whole, of the samples of a function. `range`: of the heights that count.
BrokenEdges find_broken_edges(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window,
                              double range);

}  // namespace ligne
