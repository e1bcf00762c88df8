#pragma once
/// Iso-curves of a surface z = f(x, y) with the hidden parts removed, by the floating horizon: curves are taken from the nearest to the
/// farthest, and of each is seen what lies above or below all that were taken before (Wright 1973; Anderson 1982 for both families
/// against one horizon).

#include <cstddef>
#include <functional>

#include "drawing/drawing.hpp"
#include "drawing/statistics.hpp"
#include "scene/height_source.hpp"
#include "view/view.hpp"

namespace ligne {

struct HorizonOptions {
  /// Every how many samples there is a curve: of constant x (columns of the grid) and of constant y (rows); 0 for none. The last sample has
  /// one in any case.
  std::size_t x_stride = 1, y_stride = 1;
  double z_scale = 1;  ///< heights are multiplied by it
  /// Columns of pixels of the horizon; 0: the horizon is exact.
  std::size_t resolution = 0;
  std::function<void(double)> progress{};  ///< called with the fraction done; may be empty
};

/// Rows are read from the nearest to the farthest, so memory goes with the width of the grid and with what is seen, not with the area.
/// Points in page mm. Where the eye stands over the grid, the grid is divided at its x and y into parts that can not hide each other, each
/// taken from the eye outwards. Holes (NaN) end the curves at the samples around them; the horizon hides beyond a hole as if
/// it reached from the lower to the upper horizon.
Polylines horizon_curves(const HeightSource& heights, const View& view, const HorizonOptions& options, Statistics& statistics);

/// A scene of a few faces that takes the same place in the picture as the surface does, to place the camera and the page with: the extreme
/// samples for this camera, or the corners of the bounding box when `camera` is null.
Scene stand_in(const HeightSource& heights, double z_scale, const Camera* camera);

}  // namespace ligne
