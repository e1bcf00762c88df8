#pragma once
/// How many curves of a fine grid can be told apart on the page.

#include <cstddef>

#include "view/axes/axes_box.hpp"
#include "view/view.hpp"

namespace ligne {

/// Curves are drawn no nearer to each other than so many widths of the pen, unless told otherwise.
inline constexpr double kCurveDistance = 1.5;

/// A grid over the ground of `box`, which is scaled as it is drawn.
struct GridOnPage {
  AxesBox box;
  std::size_t columns = 2, rows = 2;
  bool x_curves = true, y_curves = true;  ///< at columns, at rows
};

/// Every how many columns and rows there is a curve, so that in the middle of the ground, were it level, curves are
/// kCurveDistance apart. At least eight are left of each family, also where one sees along the ground.
std::size_t stride_apart(const GridOnPage& grid, const View& view, double pen_width_mm);

}  // namespace ligne
