#pragma once
/// Iso-curves of a surface z = f(x, y) with the hidden parts removed, by the floating horizon: the surface is taken from the
/// nearest cell to the farthest, and of each curve is seen what lies above or below all that was taken before (Wright 1973;
/// Anderson 1982 for both families against one horizon).

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/statistics.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/view.hpp"
#include "visibility/horizon/sight_line.hpp"

namespace ligne {

/// The cover: the surface, each cell of the grid as two triangles cut from (x[i+1], y[j]) to (x[i], y[j+1]); or, as in the
/// classical method, the curves that are drawn and nothing between them.
enum class HiddenBy : std::uint8_t { surface, curves };

/// Curves whose lower side is seen: with the others, apart, or not at all. (With HiddenBy::curves and `none` the space below
/// a curve hides too.)
enum class Underside : std::uint8_t { same, apart, none };

struct HorizonOptions {
  /// Every how many samples there is a curve: of constant x (columns of the grid) and of constant y (rows); 0 for none. The
  /// last sample has one in any case.
  std::size_t x_stride = 1, y_stride = 1;
  double z_scale = 1;  ///< heights are multiplied by it
  HiddenBy hidden_by = HiddenBy::surface;
  Underside underside = Underside::same;
  bool outline =
      false;  ///< the surface's silhouette and rims too, where they are not curves that are drawn; not with HiddenBy::curves
  std::vector<double> contours;  ///< heights of contour lines, ascending, before scaling; not with HiddenBy::curves
  bool contours_on_surface = true;
  std::optional<double> contour_base;  ///< the contours also on the plane of this height, before scaling
  /// Segments in the upright planes of the grid's far borders, or on a level ground that the surface stands on; heights
  /// scaled.
  std::vector<std::array<Point3, 2>> back_lines;
  /// Cells that are left out whatever their corners, row by row of the grid; may be null. Needs `holes`.
  const std::vector<char>* left_out = nullptr;
  /// Columns of pixels of the horizon; 0: the horizon is exact.
  std::size_t resolution = 0;
  std::optional<bool> holes;               ///< whether a sample may be no number; found out when not said
  std::function<void(double)> progress{};  ///< called with the fraction done; may be empty
};

/// The visible lines; points in page mm.
struct HorizonLines {
  Polylines curves, underside, outline, border, contours, base_contours;
  std::vector<std::uint32_t> contour_levels, base_levels;  ///< of each contour line the number of its height
  std::vector<std::vector<horizon::Span>> back_lines;      ///< of each the parameters that are seen, ascending
};

/// Rows are read from the nearest to the farthest, so memory goes with the width of the grid and with what is seen, not with
/// the area. Where the eye stands over the grid, the grid is divided at its x and y into parts that can not hide each other,
/// each taken from the eye outwards. A cell with a hole (a sample that is no finite number) at a corner is left out, and one
/// sees through it.
HorizonLines horizon_lines(const HeightSource& heights, const View& view, const HorizonOptions& options,
                           Statistics& statistics);

/// Extent of the heights, before scaling. `low` > `high` where there are none.
struct HeightSurvey {
  double low = 1, high = 0;
  bool holes = false;
  bool empty() const { return low > high; }
};
HeightSurvey survey(const HeightSource& heights);

/// A scene of a few faces that takes the same place in the picture as the surface does, to place the camera and the page
/// with: the corners of the bounding box, or the extreme samples for this camera.
Scene box_of(const HeightSource& heights, const HeightSurvey& survey, double z_scale);
Scene extent_scene(const HeightSource& heights, double z_scale, const Camera& camera);

}  // namespace ligne
