#pragma once
/// How long the axes of a plotted surface are in its picture.

#include <array>
#include <string>

#include "drawing/ticks.hpp"
#include "geometry/point.hpp"
#include "picture/marks/map_marks.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/axes/axes_box.hpp"

namespace ligne {

/// Unless told otherwise, x and y are drawn true to each other while their ranges differ by no more than this factor.
inline constexpr double kMostUnlike = 4;

/// Factors of the coordinates within `box` on each axis, so that the picture has the sides that the request asks
/// for; 1 where that is no finite number above zero. What was chosen is added to the report. `parametric`: the surface has a
/// shape in space, which stays true.
Point3 plot_factor(const SurfaceRequest& request, const AxesBox& box, GroundUnit unit, bool parametric, RunReport& run);

/// A number as a message tells it, with four digits.
std::string short_number(double value);

/// How the axes count.
std::array<TickScale, 3> tick_scales(const SurfaceRequest& request);

}  // namespace ligne
