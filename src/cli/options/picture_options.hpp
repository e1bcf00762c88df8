#pragma once
/// Options for the picture: view, page, fills, hatching, axes and texts.

#include <string>

#include "cli/options/options.hpp"
#include "picture/requests.hpp"
#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// `standard`: the default view shown in the help text.
void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard = "iso");

/// Options for the page and the position of the picture on it.
void add_page_options(CLI::App& app, PageRequest& request);

/// Adds --width with the names of layers. `own_layers`: allows only the program's own layers.
void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers);

/// Options for filled faces and light sources.
void add_fill_options(CLI::App& app, FillRequest& request);

/// Options for hatched faces.
void add_hatch_options(CLI::App& app, HatchRequest& request);

/// `style`: text behind --axes; empty: not given, "true": the flag alone.
void add_axes_options(CLI::App& app, AxesChoice& choice, std::string& style);

/// Puts the style into the choice. Throws UsageError for an unknown style, and for axis names without axes.
void check_axes(AxesChoice& choice, const std::string& style);

/// Options for surfaces given by three formulas in u and v, of ligne surface and ligne draw.

/// Adds --parametric X Y Z, repeatable.
void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help);

/// Adds -u and -v, repeatable: one range per surface, in order.
void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request);

}  // namespace ligne
