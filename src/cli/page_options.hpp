#pragma once
/// Options that say where on which page the picture lies.

#include <string>

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_page_options(CLI::App& app, PageRequest& request);

/// "--width": the names of layers; `own_layers`: only of ours.
void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers);

/// Reads "--page".
PageSize parse_page_size(const std::string& text);

/// Reads "--pen-width".
double parse_pen_width(const std::string& text);

}  // namespace ligne
