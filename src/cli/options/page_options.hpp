#pragma once
/// Options for the page and the position of the picture on it.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_page_options(CLI::App& app, PageRequest& request);

/// Adds --width with the names of layers. `own_layers`: allows only the program's own layers.
void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers);

}  // namespace ligne
