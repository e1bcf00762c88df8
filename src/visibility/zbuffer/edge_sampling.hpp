#pragma once
/// Tests lines against a depth buffer.
///
/// A line passes through squares whose corners are four centres of pixels. In each square it is tested at one point,
/// the middle of its part there: it is hidden if it is farther than the hiding depths of all four corners. A face in
/// front of the line that covers the surroundings of the point covers all four corners. If a corner shows something
/// else, the line is at the rim of the face in front, and is drawn. So lines continue up to a pixel behind a rim, but
/// outlines, which have a face on one side only, do not break. Centres outside the window, where faces end, are
/// ignored.

#include <cstdint>
#include <vector>

#include "visibility/common/hidden_interval.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

class EdgeSampling {
 public:
  /// `window`: faces outside it were clipped before the buffer was painted.
  EdgeSampling(const DepthBuffer& buffer, const Lattice& lattice, const Rect& window);

  /// Finds the visible parts of the line, in order, disjoint.
  void find(const PageLine& line, std::vector<LinePart>& parts) const;

 private:
  bool hidden(double u, double v, double z) const;

  const DepthBuffer& buffer_;
  PixelPlaces places_;
  std::int64_t first_column_, last_column_, first_row_, last_row_;  ///< pixels whose centres are in the window
};

}  // namespace ligne::zbuffer
