#pragma once
/// Axes, names and title round the picture of a surface.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/placement.hpp"
#include "drawing/drawing.hpp"
#include "plotting/stroke_text.hpp"
#include "scene/height_source.hpp"
#include "view/axes_layout.hpp"
#include "visibility/horizon/horizon.hpp"

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

/// Places the camera's picture and what is asked for round it on the page. `survey`: the heights that the axes' box spans; `scene`: what the page
/// must hold where there are no axes.
Surroundings place_with_axes(const HeightSource& heights, const HeightSurvey& survey, double z_scale, const Scene& scene, const Camera& camera,
                             const PageOptions& page, const AxesOptions& options, const std::string& title);

/// The lines of the axes that the surface may hide, for HorizonOptions.
std::vector<std::array<Point3, 2>> back_lines(const Surroundings& surroundings);

/// Adds the axes' lines, those behind the surface as far as the study saw them, ticks and texts to the drawing. Returns the number of
/// characters that the single-stroke font lacks.
std::size_t add_surroundings(Drawing& drawing, const Surroundings& surroundings, const AxesOptions& options, const HorizonLines& seen);

}  // namespace ligne
