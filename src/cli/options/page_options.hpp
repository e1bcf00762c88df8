#pragma once
/// Options that say where on which page the picture lies.

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_page_options(CLI::App& app, PageRequest& request);

/// "--width": the names of layers; `own_layers`: only of ours.
void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers);

}  // namespace ligne
