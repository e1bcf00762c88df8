#include "cli/commands.hpp"

namespace ligne {

void setup_commands(CLI::App& app, Commands& commands) {
  setup_draw(app, commands.draw);
  setup_surface(app, commands.surface);
  setup_plot(app, commands.plot);
  setup_compile(app, commands.compile);
  setup_info(app, commands.info);
  setup_methods(app, commands.methods);
  setup_devices(app, commands.devices);
}

}  // namespace ligne
