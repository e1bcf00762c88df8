#pragma once
/// Axes, names and title round the picture of what is plotted.

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

/// The marks drawn round a picture, and the picture's place between them.
struct Surroundings {
  Placement placement;
  AxesPicture axes;
  MapMarks map{};
  std::vector<TextItem> texts;  ///< of the axes, of the map's signs, and the title
};

/// The measure of the axes: the box before scaling, how the model's coordinates follow from its own, and how the axes count.
struct PlotBox {
  AxesBox box;
  Point3 factor{1, 1, 1};
  std::array<TickScale, 3> scales{};
  GroundUnit unit = GroundUnit::unknown;
  Point3 origin{0, 0, 0};  ///< subtracted from coordinates before they are scaled

  AxesBox in_model() const { return {(box.low - origin) * factor, (box.high - origin) * factor}; }
};

/// Height of capitals of the numbers and names. Throws RequestError.
double text_height_mm(const AxesChoice& choice, const Page& page);

/// Places the camera's picture and what is asked for round it on the page. `box` is nothing where there are no heights;
/// `scene`: what the page must hold where there are no axes.
Surroundings place_with_axes(const std::optional<PlotBox>& box, const Scene& scene, const Camera& camera,
                             const PageRequest& page, const AxesChoice& choice, const std::string& heading);

/// The lines of the axes that what is plotted may hide.
std::vector<std::array<Point3, 2>> back_lines(const Surroundings& surroundings);

/// All lines of the surroundings: the grid's, and those before it.
std::vector<std::array<Point3, 2>> all_lines(const Surroundings& surroundings);

/// The lines of the axes on the page: of back_lines() the parts `seen`, and all that is before them.
Polylines lines_of_axes(const Surroundings& surroundings, std::span<const std::vector<VisibleInterval>> seen);

/// Adds the labels that stand on the picture itself: heights of contour lines. To be called before
/// add_surroundings().
void add_labels(Drawing& drawing, const PictureRequest& request, const Surroundings& surroundings);

/// Adds ticks to the layer of the axes, which becomes the last one, the signs of a map, and texts to the drawing. Characters
/// that the single-stroke font lacks give a warning.
void add_surroundings(Drawing& drawing, const Surroundings& surroundings, const AxesChoice& choice, RunReport& run);

}  // namespace ligne
