#pragma once
/// Finds how many curves of a fine grid can be distinguished on the page.

#include <cstddef>

#include "view/axes/axes_box.hpp"
#include "view/view.hpp"

namespace ligne {

/// Least distance of curves by default, in pen widths.
inline constexpr double kCurveDistance = 1.5;

/// A grid over the ground of `box`, scaled as in the drawing.
struct GridOnPage {
  AxesBox box;
  std::size_t columns = 2, rows = 2;
  bool x_curves = true, y_curves = true;  ///< at columns, at rows
};

/// Strides of the curves, in columns and rows. On level ground at the centre, curves are then kCurveDistance apart.
/// Each family keeps at least eight curves, also if the view is along the ground.
std::size_t stride_apart(const GridOnPage& grid, const View& view, double pen_width_mm);

}  // namespace ligne
