#pragma once
/// Options for axes and texts round a plot.

#include <string>

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// `style`: text behind --axes; empty: not given, "true": the flag alone.
void add_axes_options(CLI::App& app, AxesChoice& choice, std::string& style);

/// Puts the style into the choice. Throws UsageError for an unknown style, and for axis names without axes.
void check_axes(AxesChoice& choice, const std::string& style);

}  // namespace ligne
