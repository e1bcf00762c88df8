#pragma once
/// Finds the lengths of the axes of a plotted surface in its picture.

#include <array>
#include <string>

#include "geometry/point.hpp"
#include "picture/marks/map_marks.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/axes/axes_box.hpp"
#include "view/axes/ticks.hpp"

namespace ligne {

/// By default x and y have one scale if their ranges differ by no more than this factor.
inline constexpr double kMostUnlike = 4;

/// Returns the scale factor of each axis that gives the picture of `box` the requested sides; 1 if that factor is not a
/// finite number above zero. Adds the choice to the report. `parametric`: the surface has a shape in space, which is
/// kept.
Point3 plot_factor(const SurfaceRequest& request, const AxesBox& box, GroundUnit unit, bool parametric, RunReport& run);

/// Text of a number for messages, with four digits.
std::string short_number(double value);

/// The kinds of the axes: linear or logarithmic.
std::array<TickScale, 3> tick_scales(const SurfaceRequest& request);

}  // namespace ligne
