#pragma once
/// All commands of the program, with their options.

#include "cli/compile.hpp"
#include "cli/devices.hpp"
#include "cli/draw.hpp"
#include "cli/info.hpp"
#include "cli/methods.hpp"
#include "cli/plot.hpp"
#include "cli/surface.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct Commands {
  DrawOptions draw;
  CompileOptions compile;
  InfoOptions info;
  MethodsOptions methods;
  DevicesOptions devices;
  PlotCommandOptions plot;
  SurfaceOptions surface;
};

/// Adds the commands to the program; `commands` must outlive the parse.
void setup_commands(CLI::App& app, Commands& commands);

}  // namespace ligne
