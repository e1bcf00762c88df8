#pragma once
/// Curves and points in a picture of surfaces, colours of surfaces and heights, and the legend.

#include <array>
#include <string>
#include <vector>

#include "picture/line_groups.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "view/axes/axes_box.hpp"

namespace ligne {

/// Curves in the space of the surfaces, in the units of the axes.
struct DrawnCurves {
  std::vector<std::vector<std::array<Point3, 2>>> curves;  ///< segments
  std::vector<MarkedPoint> points;
};

/// Curves on the surface lie on the first of `surfaces` with z = f(x, y). Throws RequestError, InputError.
DrawnCurves curves_of(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces, RunReport& run);

/// Clips curves to the box and drops points outside, with one warning each, along the axes whose ranges the request
/// gives (-x, -y, --z-range). Widens the box along the other axes. Returns whether the box became wider.
bool fit_to_box(const SurfaceRequest& request, DrawnCurves& drawn, AxesBox& box, RunReport& run);

/// Adds the curves to the scene; coordinates are multiplied by `factor`.
void add_curves(const DrawnCurves& drawn, const Point3& factor, LineGroups& groups);

/// Limits of the bands of heights, ascending, including the lowest and the highest height; empty without bands.
std::vector<double> band_limits(const SurfaceRequest& request, double low, double high);

/// Whether areas, and not lines, have the colours of bands or surfaces.
bool fills_colors(const SurfaceRequest& request);

/// Returns the colour of one of `count` bands, counted from the lowest: the requested colour, else one from deep green
/// over ochre to brown. Areas get a tint of it.
std::array<double, 3> band_color(const SurfaceRequest& request, std::size_t band, std::size_t count);

/// A surface of a scene, including its walls.
struct ColoredSurface {
  std::string name;
  std::uint32_t face_end;       ///< end of its faces in the scene
  std::optional<double> water;  ///< water level, before scaling
};

/// Gives faces the colours of their bands or surfaces. Water has its own colour, and so have walls if there are bands.
void color_faces(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                 const std::vector<ColoredSurface>& surfaces, Scene& scene);

/// Adds the groups of surfaces that have colours of their own, or of bands of heights. To be called when the groups of
/// contour lines are known. `face_ends`: of each surface the end end of its faces in the scene.
void add_surface_groups(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                        const std::vector<std::uint32_t>& face_ends, LineGroups& groups);

/// Returns the entries of the legend: bands, else surfaces and curves.
std::vector<LegendEntry> legend_of(const SurfaceRequest& request, const std::vector<std::string>& surfaces,
                                   const std::vector<double>& limits);

}  // namespace ligne
