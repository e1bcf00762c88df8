#pragma once
/// Axes, texts and map signs around the picture of a plot.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/marks/map_marks.hpp"
#include "picture/placement.hpp"
#include "picture/run_report.hpp"
#include "view/axes/axes_layout.hpp"
#include "view/axes/axis_lines.hpp"

namespace ligne {

/// The marks around a picture, and the placement of the picture between them.
struct PictureMarks {
  Placement placement;
  AxesPicture axes;
  MapMarks map{};
  std::vector<TextItem> texts;  ///< texts of axes and map signs, and the title
};

/// The ranges of the axes, in the coordinates of the data, and their mapping to model coordinates:
/// model = (data - origin) * factor.
struct PlotBox {
  AxesBox box;  ///< ranges of the data
  Point3 factor{1, 1, 1};
  std::array<TickScale, 3> scales{};      ///< per axis: linear or logarithmic
  GroundUnit unit = GroundUnit::unknown;  ///< unit of x and y
  Point3 origin{0, 0, 0};

  /// The box in model coordinates.
  AxesBox in_model() const { return {(box.low - origin) * factor, (box.high - origin) * factor}; }
};

/// Height of capital letters of numbers and names, mm. Throws RequestError.
double text_height_mm(const AxesChoice& choice, const Page& page);

/// Places the camera's picture on the page, with the requested axes, map signs and texts around it. `box` is empty if
/// the picture is not a plot. With axes, the box is fitted to the page unless an extent was requested.
PictureMarks place_with_axes(const std::optional<PlotBox>& box, CameraPicture picture, const PageRequest& page,
                             const AxesChoice& choice, const std::string& heading);

/// The lines of the axes that the plotted surface may hide, in model coordinates.
std::vector<std::array<Point3, 2>> back_lines(const PictureMarks& surroundings);

/// All lines of the axes, in model coordinates: those of back_lines(), then those in front of the surface.
std::vector<std::array<Point3, 2>> all_lines(const PictureMarks& surroundings);

/// The lines of the axes on the page: the visible parts `seen` of each of back_lines(), and all lines in front of the
/// surface.
Polylines lines_of_axes(const PictureMarks& surroundings, std::span<const std::vector<VisibleInterval>> seen);

/// Adds the labels inside the picture: heights of contour lines. To be called before add_surroundings().
void add_labels(Drawing& drawing, const PictureRequest& request, const PictureMarks& surroundings);

/// Adds ticks to the layer of the axes, which becomes the last one, the signs of a map, and texts to the drawing.
/// Characters that the single-stroke font lacks give a warning.
void add_surroundings(Drawing& drawing, const PictureMarks& surroundings, const AxesChoice& choice, RunReport& run);

}  // namespace ligne
