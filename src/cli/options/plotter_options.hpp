#pragma once
/// Options for pens and plotters.

#include <string>

#include "picture/pages/plotter.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct PlotterOptions {
  PlotterChoice choice;
  std::string preview;  ///< file name; empty: none
};

void add_plotter_options(CLI::App& app, PlotterOptions& options);

}  // namespace ligne
