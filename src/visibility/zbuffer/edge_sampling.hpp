#pragma once
/// Lines against a depth buffer.
///
/// A line goes through squares whose corners are four centres of pixels. In each it is tested at one point, in the middle
/// of its way through the square: it is hidden when it is farther there than the hiding depth of each corner. A face in
/// front that covers the surroundings of the point covers all four; where one of them shows something else the line is at
/// the rim of what is in front of it, and is drawn. So lines go on up to a pixel behind a rim, but outlines, which have a
/// face on one side only, do not break. Centres outside the window, where faces end, say nothing.

#include <cstdint>
#include <vector>

#include "visibility/common/hidden_interval.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

class EdgeSampling {
 public:
  /// Parts outside the window were clipped away before the buffer was painted.
  EdgeSampling(const DepthBuffer& buffer, const Lattice& lattice, const Rect& window);

  /// The visible parts of the line, in order, disjoint.
  void find(const PageLine& line, std::vector<LinePart>& parts) const;

 private:
  bool hidden(double u, double v, double z) const;

  const DepthBuffer& buffer_;
  PixelPlaces places_;
  std::int64_t first_column_, last_column_, first_row_, last_row_;  ///< whose centres are in the window
};

}  // namespace ligne::zbuffer
