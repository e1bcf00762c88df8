#pragma once
/// Axes, names and title round the picture of a surface.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/placement.hpp"
#include "drawing/drawing.hpp"
#include "plotting/stroke_text.hpp"
#include "view/axes_layout.hpp"
#include "view/axis_lines.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct AxesOptions {
  std::string style;  ///< as written: empty for no axes, "true" for the flag alone, or one of kAxesStyleNames
  std::array<std::optional<std::string>, 3> names;
  TextStyle text = TextStyle::font;
  std::optional<double> text_height_mm;
};

void add_axes_options(CLI::App& app, AxesOptions& options);

/// Throws UsageError.
void check(const AxesOptions& options);

/// What is drawn round a picture, and the picture's place between it.
struct Surroundings {
  Placement placement;
  AxesPicture axes;
  std::vector<TextItem> texts;  ///< of the axes, and the title
};

/// What the axes measure: the box, its heights before scaling.
struct PlotBox {
  AxesBox box;
  double z_scale = 1;
};

/// Places the camera's picture and what is asked for round it on the page. `box` is nothing where there are no heights;
/// `scene`: what the page must hold where there are no axes.
Surroundings place_with_axes(const std::optional<PlotBox>& box, const Scene& scene, const Camera& camera,
                             const PageOptions& page, const AxesOptions& options, const std::string& title);

/// The lines of the axes that what is plotted may hide.
std::vector<std::array<Point3, 2>> back_lines(const Surroundings& surroundings);

/// The same, and those before it.
std::vector<std::array<Point3, 2>> all_lines(const Surroundings& surroundings);

/// The lines of the axes on the page: of back_lines() the parts `seen`, and all that is before them.
Polylines lines_of_axes(const Surroundings& surroundings, std::span<const std::vector<VisibleInterval>> seen);

/// Adds ticks to the layer of the axes, which becomes the last one, and texts to the drawing. Returns the number of
/// characters that the single-stroke font lacks.
std::size_t add_surroundings(Drawing& drawing, const Surroundings& surroundings, const AxesOptions& options);

}  // namespace ligne
