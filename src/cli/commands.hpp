#pragma once
/// All commands of the program and their options.

#include "cli/commands/compare.hpp"
#include "cli/commands/compile.hpp"
#include "cli/commands/devices.hpp"
#include "cli/commands/draw.hpp"
#include "cli/commands/info.hpp"
#include "cli/commands/methods.hpp"
#include "cli/commands/plot.hpp"
#include "cli/commands/surface.hpp"
#include "cli/study_program.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct Commands {
  DrawOptions draw;
  CompareOptions compare;
  CompileOptions compile;
  InfoOptions info;
  MethodsOptions methods;
  DevicesOptions devices;
  PlotCommandOptions plot;
  SurfaceOptions surface;
};

/// Adds the commands to the program; `commands` must outlive the parse.
inline void setup_commands(CLI::App& app, Commands& commands) {
  setup_draw(app, commands.draw);
  setup_surface(app, commands.surface);
  setup_plot(app, commands.plot);
  setup_compile(app, commands.compile);
  setup_info(app, commands.info);
  setup_compare(app, commands.compare);
  setup_methods(app, commands.methods);
  setup_devices(app, commands.devices);
  add_study_command(app);
}

}  // namespace ligne
