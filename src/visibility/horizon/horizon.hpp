#pragma once
/// Draws iso-curves of a surface z = f(x, y) with hidden parts removed, by the floating horizon. The sweep takes the
/// surface from the nearest cell to the farthest; a curve is visible where it lies above or below everything taken
/// before (Wright 1973; Anderson 1982 for both families against one horizon).

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/statistics.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/view.hpp"
#include "visibility/horizon/plane_projection.hpp"

namespace ligne {

/// The objects that hide: the surface, where each cell of the grid is two triangles cut from (x[i+1], y[j]) to (x[i],
/// y[j+1]); or, as in the classical method, the drawn curves and nothing between them.
enum class HiddenBy : std::uint8_t { surface, curves };

/// Use of curves whose lower side is visible: drawn with the others, kept apart, or left out. (With HiddenBy::curves
/// and `none` the space below a curve hides too.)
enum class Underside : std::uint8_t { same, apart, none };

struct HorizonOptions {
  /// Samples from curve to curve: of constant x (columns of the grid) and of constant y (rows); 0 for no curves. The
  /// last sample always has one.
  std::size_t x_stride = 1, y_stride = 1;
  double z_scale = 1;  ///< heights are multiplied by it
  HiddenBy hidden_by = HiddenBy::surface;
  Underside underside = Underside::same;
  bool outline =
      false;  ///< draw the surface's silhouette and rims too, except where a curve is drawn; not with HiddenBy::curves
  std::vector<double> contours;  ///< heights of contour lines, ascending, before scaling; not with HiddenBy::curves
  bool contours_on_surface = true;
  std::optional<double> contour_base;  ///< height of a plane onto which the contours are drawn too, before scaling
  /// Segments in the vertical planes at the grid's far borders, or on level ground on which the surface stands; heights
  /// are scaled.
  std::vector<std::array<Point3, 2>> back_lines;
  /// Per cell, row by row of the grid: 1 if the cell is left out in any case; may be null. Needs `holes`.
  const std::vector<char>* left_out = nullptr;
  /// Columns of pixels of the horizon; 0: the horizon is exact.
  std::size_t resolution = 0;
  std::optional<bool> holes;               ///< whether samples may be missing; found by a survey if not given
  std::function<void(double)> progress{};  ///< called with the fraction done; may be empty
};

/// The visible lines; points in page mm.
struct HorizonLines {
  Polylines curves, underside, outline, border, contours, base_contours;
  std::vector<std::uint32_t> contour_levels, base_levels;  ///< per contour line: number of its height
  std::vector<std::vector<horizon::Span>> back_lines;      ///< per back line: its visible parameters, ascending
};

/// Rows are read from the nearest to the farthest, so memory grows with the width of the grid and with the visible
/// lines, not with the area. If the eye stands over the grid, its x and y divide the grid into parts that cannot hide
/// each other, and each part is taken from the eye outwards. A cell with a hole (a sample that is not finite) at a
/// corner is left out: it hides nothing.
HorizonLines horizon_lines(const HeightSource& heights, const View& view, const HorizonOptions& options,
                           Statistics& statistics);

/// Extent of the heights, before scaling. `low` > `high` if there are none.
struct HeightSurvey {
  double low = 1, high = 0;
  bool holes = false;
  bool empty() const { return low > high; }
};
HeightSurvey survey(const HeightSource& heights);

/// A scene of a few faces with the extent of the surface, for placing the camera and the page: the corners of the
/// bounding box, or the extreme samples for this camera.
Scene box_of(const HeightSource& heights, const HeightSurvey& survey, double z_scale);
Scene extent_scene(const HeightSource& heights, double z_scale, const Camera& camera);

}  // namespace ligne
