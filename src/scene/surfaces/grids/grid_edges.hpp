#pragma once
/// Finds the edges of a formula's grid of samples on which the surface breaks off.

#include <vector>

#include "scene/surfaces/height_breaks.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// An edge runs from a sample to the next one in its row, or in its column.
struct GridEdge {
  std::size_t sample = 0;  ///< index of its first sample, row by row
  bool along_column = false;

  std::size_t key() const { return 2 * sample + along_column; }
};

struct BrokenEdge {
  GridEdge edge;
  std::vector<LinePiece> pieces;
};

struct BrokenEdges {
  std::vector<BrokenEdge> edges;    ///< ascending by first sample
  HeightWindow poles = kNoHeights;  ///< range of the heights that were reached at poles
};

/// Largest invisible height, relative to the range of heights.
inline constexpr double kLeastHeightPart = 0x1p-10;

/// The range of the samples that count in a window.
struct SampleSpan {
  double low = 0, high = 0;
  Point2 lowest{}, highest{};    ///< positions of these
  bool any = false, all = true;  ///< whether any sample counts, and whether all do

  double range() const { return high - low; }
};
SampleSpan span_of_samples(const HeightSource& heights, const HeightWindow& window);

/// Finds all edges of the samples of a function on which the surface is not one unbroken piece. `range`: range of the
/// heights that count.
BrokenEdges find_broken_edges(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window,
                              double range);

}  // namespace ligne
