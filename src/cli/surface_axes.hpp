#pragma once
/// Axes, names and title round the picture of a surface.

#include <array>
#include <optional>
#include <string>

#include "cli/placement.hpp"
#include "drawing/drawing.hpp"
#include "plotting/stroke_text.hpp"
#include "scene/height_source.hpp"
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

/// Places the camera's picture and what is asked for round it on the page.
Surroundings place_with_axes(const HeightSource& heights, double z_scale, const Camera& camera, const PageOptions& page,
                             const AxesOptions& options, const std::string& title);

/// Adds the axes' lines, as far as they are visible, ticks and texts to the drawing. Returns the number of characters that the
/// single-stroke font lacks.
std::size_t add_surroundings(Drawing& drawing, const Surroundings& surroundings, const AxesOptions& options, const LineVisibility& visibility);

}  // namespace ligne
