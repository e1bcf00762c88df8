#pragma once
/// Curves and points on a picture of surfaces, colours of surfaces and of heights, and the legend of them.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "picture/line_groups.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "view/axes/axes_box.hpp"
#include "view/view.hpp"

namespace ligne {

/// Curves drawn in the space of the surfaces, at the numbers of the axes.
struct DrawnCurves {
  std::vector<std::vector<std::array<Point3, 2>>> curves;  ///< segments
  std::vector<MarkedPoint> points;
};

/// `surfaces`: curves lie on the first one of z = f(x, y). Throws RequestError, InputError.
DrawnCurves curves_of(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces, RunReport& run);

/// Ends curves at the sides of the box along the axes whose ranges the request says (-x, -y, --z-range), leaves out points
/// beyond them, with a warning of each, and widens the box along the other axes. Returns whether the box became wider.
bool fit_to_box(const SurfaceRequest& request, DrawnCurves& drawn, AxesBox& box, RunReport& run);

/// Adds them, in coordinates times `factor`.
void add_curves(const DrawnCurves& drawn, const Point3& factor, LineGroups& groups);

/// Limits of the bands of heights, ascending, the lowest and the highest height among them; none without bands.
std::vector<double> band_limits(const SurfaceRequest& request, double low, double high);

/// Whether areas are in the colours of bands or surfaces; lines then are not.
bool fills_colors(const SurfaceRequest& request);

/// The colour of one of `count` bands, from the lowest on: as asked for, else from deep green over ochre to brown, of areas
/// as tints.
std::array<double, 3> band_color(const SurfaceRequest& request, std::size_t band, std::size_t count);

/// A surface of a scene, its walls with it.
struct ColoredSurface {
  std::string name;
  std::uint32_t face_end;       ///< of its faces in the scene
  std::optional<double> water;  ///< its level, before scaling
};

/// Gives faces the colours of their bands, or of their surfaces. Water has a colour of its own, and so have walls where
/// there are bands.
void color_faces(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                 const std::vector<ColoredSurface>& surfaces, Scene& scene);

/// Adds the groups of surfaces that have colours of their own, or of bands of heights. To be called when the groups of
/// contour lines are known. `face_ends`: of each surface the end of its faces in the scene.
void add_surface_groups(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                        const std::vector<std::uint32_t>& face_ends, LineGroups& groups);

/// The lines of the legend: bands, else surfaces and curves.
std::vector<LegendEntry> legend_of(const SurfaceRequest& request, const std::vector<std::string>& surfaces,
                                   const std::vector<double>& limits);

}  // namespace ligne
