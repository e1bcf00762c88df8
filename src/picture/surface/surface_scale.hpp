#pragma once
/// Finds the lengths of the axes of a plotted surface in its picture.

#include <array>
#include <cstddef>
#include <string>

#include "geometry/point.hpp"
#include "picture/marks/map_marks.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/axes/axes_box.hpp"
#include "view/axes/ticks.hpp"
#include "view/view.hpp"

namespace ligne {

/// By default x and y have one scale if their ranges differ by no more than this factor.
inline constexpr double kMostUnlike = 4;

/// Returns the scale factor of each axis that gives the picture of `box` the requested sides; 1 if that factor is not a
/// finite number above zero. Adds the choice to the report. `parametric`: the surface has a shape in space, which is
/// kept.
Point3 plot_factor(const SurfaceRequest& request, const AxesBox& box, GroundUnit unit, bool parametric, RunReport& run);

/// Text of a number for messages, with four digits.
std::string short_number(double value);

/// The contour_levels(). Warns if none of the heights that the request gives lies between `low` and `high`.
std::vector<double> levels_in_heights(const CurveRequest& request, double low, double high, bool decades, RunReport& run);

/// The kinds of the axes: linear or logarithmic.
std::array<TickScale, 3> tick_scales(const SurfaceRequest& request);

/// Least distance of curves by default, in pen widths.
inline constexpr double kCurveDistance = 1.5;

/// A grid over the ground of `box`, scaled as in the drawing.
struct GridOnPage {
  AxesBox box;
  std::size_t columns = 2, rows = 2;
  bool x_curves = true, y_curves = true;  ///< at columns, at rows
};

/// Strides of the curves, in columns and rows. On level ground at the centre, curves are then kCurveDistance apart.
/// Each family keeps at least eight curves, also if the view is along the ground, and all of them if it has fewer.
struct Strides {
  std::size_t x = 1, y = 1;
};
Strides strides_apart(const GridOnPage& grid, const View& view, double pen_width_mm);

/// Sets and reports the strides of the families that are drawn.
template <class Curves>
void set_strides(const Strides& strides, Curves& curves, RunReport& run) {
  const std::string x = std::to_string(strides.x), y = std::to_string(strides.y);
  if (strides.x > 1 || strides.y > 1)
    run.choices.emplace_back("every", (x == y ? x : x + " x " + y) + ", to keep curves distinct");
  if (curves.x_stride > 0) curves.x_stride = strides.x;
  if (curves.y_stride > 0) curves.y_stride = strides.y;
}

}  // namespace ligne
